#include "collocation/march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "collocation/panel_equations.hpp"
#include "march/pace.hpp"
#include "march/rhs_noise.hpp"
#include "march/singularity.hpp"

namespace fde {

namespace {

template <typename Failure = std::runtime_error>
[[noreturn]] void fail(const std::string& what, double t) {
  std::ostringstream message;
  message.precision(10);
  message << "collocation: " << what << " at t = " << t;
  throw Failure(message.str());
}

// By which factor a panel could have been longer; below 1 it is not resolved. Legendre coefficients fall like
// rho^-k, and a panel longer by a factor q has about rho / q for rho. Even and odd coefficients may fall
// differently, so the last two have to be negligible.
double possible_growth(const Matrix& coefficients, const Vec& negligible, double tolerance) {
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

// Two panels of equal length rather than a long one and a sliver.
double next_break(double from, double length, double end) {
  const double left = end - from;
  if (left <= length) {
    return end;
  }
  return from + (left < 2 * length ? left / 2 : length);
}

Vec rhs_at(const Problem& problem, double t, const Vec& y) {
  Vec rhs(problem.size());
  problem.rhs(t, y, rhs);
  return rhs;
}

Sizes sizes_at_start(const Problem& problem) {
  constexpr int samples = 64;
  const Vec initial = taylor_part(problem, 0.0);
  const Vec rhs = rhs_at(problem, 0.0, initial).cwiseAbs();
  Sizes sizes{initial.cwiseAbs(), rhs, rhs, Vec::Zero(problem.size())};
  for (int k = 1; k <= samples; ++k) {
    const Vec sample = rhs_at(problem, problem.end * k / samples, initial).cwiseAbs();
    if (sample.allFinite()) {
      sizes.forcing = sizes.forcing.cwiseMax(sample);
    }
  }
  return sizes;
}

constexpr double noise = 16 * std::numeric_limits<double>::epsilon();
constexpr double noises = 4.0;  // the sum of some rounding errors

class March {
 public:
  March(const Problem& problem, const MarchOptions& options, const PanelBasis& basis)
      : problem_(problem),
        options_(options),
        basis_(basis),
        history_(problem, basis),
        equations_(problem, basis),
        rhs_noise_(problem) {}

  std::vector<Panel> run() {
    constexpr std::size_t most_panels = 2000;
    while (time() < problem_.end) {
      if (panels_.size() == most_panels || hopeless(most_panels)) {
        fail("more panels than it can afford", time());
      }
      add_panel();
    }
    return std::move(panels_);
  }

 private:
  [[nodiscard]] double time() const { return panels_.empty() ? 0.0 : panels_.back().to; }

  [[nodiscard]] bool hopeless(std::size_t most_panels) const {
    constexpr std::size_t watched = 100;
    if (panels_.size() <= watched) {
      return false;
    }
    const double before = panels_[panels_.size() - 1 - watched].to;
    return fde::hopeless(before, time(), watched, problem_.end, most_panels - panels_.size());
  }

  // Halves the panel until it resolves the solution.
  void add_panel() {
    constexpr double slow = 1.2;  // growth at which noise may be in the way
    constexpr int most_attempts = 60;
    constexpr double shortest = 1e-12;  // relative to the time
    const double from = time();
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      const double to = next_break(from, length_, problem_.end);
      if (to - from <= shortest * from) {
        break;
      }
      const auto solution =
          equations_.solve(history_.at_targets(panels_, from, to), from, to, last_rhs_, sizes_);
      const double growth = solution ? growth_after(*solution, to) : 0.5;
      if (growth < slow && (solution ? noise_found(*solution, from, to) : noise_found_before())) {
        sizes_.noise = rhs_noise_.found();
        continue;
      }
      length_ = growth * (to - from);
      if (growth >= 1.0) {
        require_inside(*solution, from, to);
        return accept(*solution, from, to);
      }
    }
    fail("no convergence", from);
  }

  // Polynomials pass a pole of f between their nodes as if it were not there.
  void require_inside(const PanelEquations::Solution& solution, double from, double to) const {
    for (Eigen::Index k = 0; k < basis_.targets.size(); ++k) {
      const double t = from + (to - from) * basis_.targets[k];
      if (!problem_.domain.contains(t, solution.values.row(k).transpose()))
        fail<Singularity>("singularity, " + problem_.domain.edge + ",", t);
    }
  }

  [[nodiscard]] Vec negligible_rhs(const PanelEquations::Solution& solution) const {
    return options_.tolerance * solution.sizes.rhs + noise * solution.sizes.forcing +
           noises * solution.noise.rhs;
  }

  // Whether rounding of f keeps a panel from being resolved that was not known to do so.
  bool noise_found(const PanelEquations::Solution& solution, double from, double to) {
    constexpr Eigen::Index tail = 4;
    const Vec negligible = negligible_rhs(solution);
    const Matrix coefficients = basis_.legendre * solution.rhs;
    const Vec unresolved = coefficients.bottomRows(tail).cwiseAbs().colwise().maxCoeff();
    const double scale = sizes_.largest();  // so far: the solution of too long a panel may be a wild one
    return rhs_noise_.find(from + (to - from) * basis_.nodes.array(),
                           solution.values.topRows(basis_.points()), unresolved, negligible, scale);
  }

  [[nodiscard]] Vec explained_noise() const {
    return noises * std::numeric_limits<double>::epsilon() * (sizes_.rhs + sizes_.forcing);
  }

  // The same where a panel has no solution: on the panel before it.
  bool noise_found_before() {
    if (panels_.empty()) {
      return false;
    }
    const Panel& last = panels_.back();
    const Vec negligible = noise * (sizes_.rhs + sizes_.forcing);
    const Vec unresolved = negligible.cwiseMax(std::numeric_limits<double>::min());
    return rhs_noise_.find(last.from + last.length() * basis_.dense_nodes.array(), last.values, unresolved,
                           negligible, sizes_.largest());
  }

  [[nodiscard]] double growth_after(const PanelEquations::Solution& solution, double to) const {
    constexpr double weightless = 1e-18;  // of the end: an error of f before it is lost in rounding later on
    if (to <= weightless * problem_.end) {
      return panels_.empty() ? 1.0 : 2.0;
    }
    const double tolerance = options_.tolerance;
    const Matrix values = solution.values.topRows(basis_.points());
    const Vec negligible_value =
        tolerance * solution.sizes.values + noise * solution.increment + noises * solution.noise.values;
    return std::min({possible_growth(basis_.legendre * solution.rhs, negligible_rhs(solution), tolerance),
                     possible_growth(basis_.legendre * values, negligible_value, tolerance), 2.0});
  }

  void accept(const PanelEquations::Solution& solution, double from, double to) {
    Matrix values(basis_.points() + 2, problem_.size());
    values << last_value_.transpose(), solution.values;
    last_value_ = values.bottomRows<1>().transpose();
    last_rhs_ = rhs_at(problem_, to, last_value_);
    sizes_ = solution.sizes;
    noise_ = noise_.cwiseMax(solution.noise.values);
    noise_of_rhs_.push_back(sizes_.noise);
    const Vec size = solution.sizes.values + solution.increment +
                     (noise_ + integrated_noise(from, to)) / std::numeric_limits<double>::epsilon();
    panels_.push_back({from, to, solution.rhs, values, size});
    rhs_noise_.follow(from + (to - from) * basis_.dense_nodes.array(), values, explained_noise());
    sizes_.noise = rhs_noise_.found();
  }

  // What the noise of f adds to y at most, should it always have the same sign.
  [[nodiscard]] Vec integrated_noise(double from, double to) const {
    Vec sum = increment_of(problem_, noise_of_rhs_.back(), to - from);
    for (std::size_t k = 0; k < panels_.size(); ++k) {
      if (noise_of_rhs_[k].isZero(0.0)) {
        continue;
      }
      sum += (increment_of(problem_, noise_of_rhs_[k], to - panels_[k].from) -
              increment_of(problem_, noise_of_rhs_[k], to - panels_[k].to))
                 .cwiseMax(0.0);
    }
    return sum;
  }

  const Problem& problem_;
  const MarchOptions& options_;
  const PanelBasis& basis_;
  VolterraHistory history_;
  PanelEquations equations_;
  std::vector<Panel> panels_;
  double length_ = options_.first_panel * problem_.end;  // of the panel to try next
  Vec last_value_ = taylor_part(problem_, 0.0);
  Vec last_rhs_ = rhs_at(problem_, 0.0, last_value_);
  Sizes sizes_ = sizes_at_start(problem_);
  Vec noise_ = Vec::Zero(problem_.size());  // of y, the largest so far
  RhsNoise rhs_noise_;
  std::vector<Vec> noise_of_rhs_;  // on each panel
};

}  // namespace

PiecewiseSolution::PiecewiseSolution(const Problem& problem, const MarchOptions& options)
    : basis_(options.points), panels_(March(problem, options, basis_).run()) {}

std::size_t PiecewiseSolution::panel_of(double t) const {
  const auto panel = std::ranges::lower_bound(panels_, t, {}, &Panel::to);
  return static_cast<std::size_t>(panel - panels_.begin());
}

Vec PiecewiseSolution::at(double t) const {
  const Panel& panel = panels_[panel_of(t)];
  return basis_.interpolate(panel.values, (t - panel.from) / panel.length());
}

}  // namespace fde
