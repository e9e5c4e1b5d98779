// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/collocation/piecewise_solution.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "fdebench/reference/nonlinear/collocation/panel_equations.hpp"
#include "fdebench/reference/nonlinear/march/march_limits.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {

namespace {

template <typename Failure = std::runtime_error>
[[noreturn]] void fail(const std::string& what, double t) {
  std::ostringstream message;
  message.precision(10);
  message << "collocation: " << what << " at t = " << t;
  throw Failure(message.str());
}

// Factor by which a panel could have been longer; below 1 the panel does not resolve the solution. Legendre
// coefficients decay like rho^-k, and a panel longer by a factor q has about rho / q for rho. Even and odd
// coefficients may decay differently, so the last two have to be negligible.
double growth_factor(const Matrix& coefficients, const Vec& negligible, double tolerance) {
  const Eigen::Index allowed = coefficients.rows() - 2;
  Eigen::Index needed = coefficients.rows();
  while (needed > 1 && (coefficients.row(needed - 1).transpose().array().abs() <= negligible.array()).all()) {
    --needed;
  }
  if (needed > allowed) {
    return 0.5;
  }
  return std::pow(tolerance, 1.0 / static_cast<double>(allowed) - 1.0 / static_cast<double>(needed));
}

// Two panels of equal length rather than a long and a very short one.
double panel_end(double from, double length, double end) {
  const double left = end - from;
  if (left <= length) {
    return end;
  }
  return from + (left < 2 * length ? left / 2 : length);
}

PanelPoints points_for(const Problem& problem) {
  return has_algebraic_rows(problem) ? PanelPoints::radau : PanelPoints::legendre;
}

// The panel that ends at or after t, or the last one.
std::size_t panel_at(double t, const std::vector<Panel>& panels) {
  const auto panel = std::ranges::lower_bound(panels, t, {}, &Panel::to);
  return std::min(static_cast<std::size_t>(panel - panels.begin()), panels.size() - 1);
}

Vec value_at(double t, const std::vector<Panel>& panels, const PanelBasis& basis) {
  const Panel& panel = panels[panel_at(t, panels)];
  return basis.interpolate(panel.values, std::min((t - panel.from) / panel.length(), 1.0));
}

class CollocationSolver {
 public:
  // The times of events are added to those at which the problem jumps.
  CollocationSolver(Problem& problem, const PanelOptions& options, const PanelBasis& basis)
      : problem_(problem),
        options_(options),
        basis_(basis),
        history_(problem, basis),
        equations_(problem, basis),
        noise_(problem, basis, options.tolerance) {}

  std::vector<Panel> run() {
    if (options_.looking_back != nullptr) {
      options_.looking_back->set_solution(
          [this](double t, Out y) { y = panels_.empty() ? last_value_ : value_at(t, panels_, basis_); });
    }
    while (time() < problem_.end) {
      // After each jump they double from 1e-11 of the time on.
      const std::size_t most_panels = 2000 + 50 * problem_.jump_times.size();
      if (panels_.size() == most_panels || cannot_reach_end(most_panels)) {
        fail("more panels than it can afford", time());
      }
      report_progress(panels_.size());
      add_panel();
    }
    return std::move(panels_);
  }

  [[nodiscard]] const ResetLocator& resets() const { return resets_; }

 private:
  using Solution = PanelEquations::Solution;

  [[nodiscard]] double time() const { return panels_.empty() ? 0.0 : panels_.back().to; }

  [[nodiscard]] bool cannot_reach_end(std::size_t most_panels) const {
    constexpr std::size_t output_times = 100;
    if (panels_.size() <= output_times) {
      return false;
    }
    const double before = panels_[panels_.size() - 1 - output_times].to;
    if (last_jump(problem_, time()) > before) return false;  // where panels are short for a while
    return fde::reference::cannot_reach_end(before, time(), output_times, problem_.end,
                                            most_panels - panels_.size());
  }

  // Halves the panel until it resolves the solution.
  void add_panel() {
    constexpr double slow = 1.2;  // growth below which noise may be the cause
    constexpr int most_attempts = 60;
    constexpr double shortest = 1e-12;  // relative to the time
    const double from = time();
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      const double to = panel_end(from, std::min(length_, longest_step(problem_, from)),
                                  std::min(next_discontinuity(problem_, from), resets_.next()));
      if (to - from <= shortest * from) {
        break;
      }
      const auto solution =
          equations_.solve(history_.at_targets(panels_, from, to), from, to, last_rhs_, sizes_);
      const double growth = solution ? panel_growth(*solution, from, to) : 0.5;
      if (growth < slow && noise_found(solution, from, to)) {
        sizes_.noise = noise_.known_rhs_noise();
        continue;
      }
      length_ = growth * (to - from);
      if (growth < 1.0 || cut_by_event(*solution, from, to)) continue;
      if (resets_.next() <= from) return pass_event();
      require_in_domain(*solution, from, to);
      return accept(*solution, from, to);
    }
    fail("no convergence", from);
  }

  // Factor for the length of the next panel; below 1 this panel does not resolve y and f.
  [[nodiscard]] double panel_growth(const Solution& solution, double from, double to) const {
    if (to <= options_.negligible_before * problem_.end) {
      return panels_.empty() ? 1.0 : 2.0;
    }
    if (just_after_jump(problem_, from, to)) {
      return jumps_at(problem_, from) ? 1.0 : 2.0;
    }
    const Matrix values = solution.values.topRows(basis_.points());
    const double tolerance = options_.tolerance;
    return std::min(
        {growth_factor(basis_.legendre * solution.rhs, noise_.negligible_rhs(solution), tolerance),
         growth_factor(basis_.legendre * values, noise_.negligible_values(solution), tolerance), 2.0});
  }

  bool noise_found(const std::optional<Solution>& solution, double from, double to) {
    // The sizes before this panel: on too long a panel the solution may be far too large.
    if (solution) return noise_.detect(*solution, from, to, sizes_.largest());
    return !panels_.empty() && noise_.detect(panels_.back(), sizes_);
  }

  // y on the panel [from, to].
  [[nodiscard]] Matrix values_of(const Solution& solution) const {
    Matrix values(basis_.dense_nodes.size(), problem_.size());
    values << last_value_.transpose(), solution.values;
    return values;
  }
  [[nodiscard]] ResetLocator::Path path(const Matrix& values, double from, double to) const {
    return
        [this, &values, from, to](double t) { return basis_.interpolate(values, (t - from) / (to - from)); };
  }

  // Whether y jumps within the panel, so that it must end there. An event at its start is the next one.
  bool cut_by_event(const Solution& solution, double from, double to) {
    if (problem_.resets.empty()) return false;
    const Matrix values = values_of(solution);
    const auto event = resets_.find(from, to, path(values, from, to));
    return event && *event > from && *event < to;
  }

  void pass_event() {
    const double t = time();
    Vec after = last_value_;
    resets_.pass(after);
    history_.add_jump(after - last_value_);
    last_value_ = after;
    last_rhs_ = rhs_at(problem_, t, after);
    add_jump_time(problem_, t);
    length_ = options_.first_after_jump * t;
  }

  // Required since polynomials do not detect a pole of f between their nodes.
  void require_in_domain(const Solution& solution, double from, double to) const {
    for (Eigen::Index k = 0; k < basis_.targets.size(); ++k) {
      const double t = from + (to - from) * basis_.targets[k];
      if (!problem_.domain.contains(t, solution.values.row(k).transpose()))
        fail<Singularity>("singularity, " + problem_.domain.edge + ",", t);
    }
  }

  void accept(const Solution& solution, double from, double to) {
    constexpr double few_digits = 1e-3;
    const Matrix values = values_of(solution);
    resets_.accept(from, to, path(values, from, to));
    last_value_ = values.bottomRows<1>().transpose();
    last_rhs_ = rhs_at(problem_, to, last_value_);
    const Vec size = noise_.record_panel(solution, from, to, values);
    // Values that are mostly noise, as those driven by a multiplier on the first panels, are no scale for
    // later ones.
    const auto has_digits = solution.noise.values.array() <
                            few_digits * values.cwiseAbs().colwise().maxCoeff().transpose().array();
    sizes_.values = has_digits.select(solution.sizes.values, sizes_.values);
    sizes_.rhs = solution.sizes.rhs;
    sizes_.forcing = solution.sizes.forcing;
    sizes_.noise = noise_.known_rhs_noise();
    panels_.push_back({from, to, solution.rhs, values, size, noise_.negligible_rhs(solution)});
    if (jumps_at(problem_, to)) length_ = options_.first_after_jump * to;
    if (resets_.next() <= to) pass_event();
  }

  Problem& problem_;
  const PanelOptions& options_;
  const PanelBasis& basis_;
  HistoryTerm history_;
  PanelEquations equations_;
  PanelNoise noise_;
  std::vector<Panel> panels_;
  double length_ = options_.first_panel * problem_.end;  // of the next panel
  Vec last_value_ = taylor_part(problem_, 0.0);
  Vec last_rhs_ = rhs_at(problem_, 0.0, last_value_);
  MagnitudeScales sizes_ = sizes_at_start(problem_);
  ResetLocator resets_{problem_};
};

}  // namespace

PiecewiseSolution::PiecewiseSolution(const Problem& problem, const PanelOptions& options)
    : problem_(problem),
      negligible_before_(options.negligible_before * problem.end),
      basis_(options.points, points_for(problem)) {
  CollocationSolver solver(problem_, options, basis_);
  panels_ = solver.run();
  events_ = solver.resets().events();
  const auto last = [this](double t) {
    const Panel& panel = panels_.back();
    return basis_.interpolate(panel.values, (t - panel.from) / panel.length());
  };
  event_at_end_ = solver.resets().next_to(problem_.end, last);
  const auto inner = static_cast<int>(basis_.dense_nodes.size()) - 2;
  kept_ = PanelBasis(inner, PanelPoints::legendre).dense_nodes;
  if (options.looking_back != nullptr)
    options.looking_back->set_solution([this](double t, Out y) { y = at(t); });
}

Matrix PiecewiseSolution::legendre_values(const Panel& panel, double from, double to) const {
  const bool is_part = from > panel.from || to < panel.to;
  if (kept_ == basis_.dense_nodes && !is_part) return panel.values;
  Vec places = kept_;
  if (is_part) places = ((from - panel.from) + (to - from) * kept_.array()) / panel.length();
  Matrix values(places.size(), panel.values.cols());
  for (Eigen::Index k = 0; k < places.size(); ++k)
    values.row(k) = basis_.interpolate(panel.values, places[k]).transpose();
  return values;
}

bool PiecewiseSolution::is_resolved(const Panel& panel) const {
  return panel.to > negligible_before_ && !just_after_jump(problem_, panel.from, panel.to);
}

std::size_t PiecewiseSolution::panel_of(double t) const { return panel_at(t, panels_); }

Vec PiecewiseSolution::at(double t) const { return value_at(t, panels_, basis_); }

}  // namespace fde::reference
