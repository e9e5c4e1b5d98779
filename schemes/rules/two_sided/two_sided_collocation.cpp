// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/two_sided_collocation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fdebench/schemes/rules/spectral/panel_rule.hpp"
#include "fdebench/schemes/rules/two_sided/global_solver.hpp"
#include "fdebench/schemes/rules/two_sided/panel_side.hpp"
#include "fdebench/schemes/stepping/error_tolerance.hpp"

namespace fde {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double shortest = 0x1p-250;  // panel that is divided, of the end
constexpr std::size_t most_panels = 500;
constexpr int most_divisions = 24;    // of a panel before the equations are solved again
constexpr int most_first_meshes = 3;  // for which a solution is searched for

// Enough for panels of which each is as long as its distance from a singular edge.
LegendrePoints points_for(const Tolerance& accuracy) {
  const double digits = -std::log10(std::max(accuracy.rtol, accuracy.atol));
  return LegendrePoints(std::clamp<Eigen::Index>(4 + std::lround(digits), 6, 16));
}

// A solution on panels, at any time: a polynomial through the values at the points of a panel; next to a
// singular edge the integrals of f, which is a polynomial there.
class SolutionOnPanels {
 public:
  SolutionOnPanels(std::shared_ptr<const Problem> problem, PanelMesh mesh,
                   std::shared_ptr<const LegendrePoints> points)
      : problem_(std::move(problem)),
        mesh_(std::move(mesh)),
        points_(std::move(points)),
        left_(std::make_shared<PanelSide>(*problem_, Side::left, mesh_, *points_)),
        right_(std::make_shared<PanelSide>(*problem_, Side::right, mesh_, *points_)),
        equations_(*problem_, discretisation_by_panels(*problem_, mesh_, *points_, left_, right_)),
        from_start_(mesh_.edges()),
        from_end_(mesh_.mirrored().edges().reverse()) {
    from_start_[panels()] = from_end_[0] = problem_->end;
  }

  [[nodiscard]] const Problem& problem() const { return *problem_; }
  [[nodiscard]] const PanelMesh& mesh() const { return mesh_; }
  [[nodiscard]] const GlobalEquations& equations() const { return equations_; }
  [[nodiscard]] Eigen::Index panels() const { return static_cast<Eigen::Index>(mesh_.size()); }
  [[nodiscard]] double edge(Eigen::Index k) const { return from_start_[k]; }

  // The solution at the times of the equations.
  void set(Run& run, GridFunction values) {
    values_ = std::move(values);
    f_ = equations_.residual(run, values_).f;
  }

  [[nodiscard]] Vec at(double t) const { return at(t, problem_->end - t); }

  // The solution of another mesh at the times of this one.
  [[nodiscard]] GridFunction interpolated_from(const SolutionOnPanels& other) const {
    const auto& [left, right, left_rule, right_rule, with_steps] = equations_.discretisation();
    GridFunction values{.y = Rows(problem_->size(), equations_.times()), .unknown = other.values_.unknown};
    for (Eigen::Index n = 0; n < equations_.times(); ++n) values.y.col(n) = other.at(left[n], right[n]);
    return values;
  }

  // The largest error of a row on a panel, in units of the tolerance, by its last Legendre coefficients.
  [[nodiscard]] double error(std::size_t panel, const Tolerance& accuracy) const {
    const auto first = 1 + static_cast<Eigen::Index>(panel) * count();
    const Matrix y = values_.y.middleCols(first, count()).transpose();
    const Matrix f = f_.middleCols(first, count()).transpose();
    const Vec terms = values_.y.cwiseAbs().rowwise().maxCoeff();
    const Vec allowed = ErrorTolerance(accuracy).on_step(
        y.cwiseAbs().colwise().minCoeff().transpose(), y.cwiseAbs().colwise().maxCoeff().transpose(), terms);
    const Vec of_y = last_coefficients(y), of_f = last_coefficients(f);
    const bool singular = mesh_.touches_singular_edge(panel);
    double largest = 0.0;
    for (Eigen::Index i = 0; i < problem_->size(); ++i) {
      double off = unit_of_rhs(panel, i) * of_f[i];
      if (!singular) off = std::max(off, of_y[i]);
      if (singular && problem_->is_algebraic(i)) off = static_cast<double>(count()) * of_y[i];
      largest = std::max(largest, off / allowed[i]);
    }
    if (!std::isfinite(largest)) return infinity;
    return largest;
  }

 private:
  [[nodiscard]] Eigen::Index count() const { return points_->points.size(); }

  // y at a time at these distances from the start and from the end.
  [[nodiscard]] Vec at(double left, double right) const {
    if (left <= 0.0) return values_.y.col(0);
    if (right <= 0.0) return values_.y.rightCols<1>();
    const auto [panel, since] = place_of(left, right);
    const Vec weights = points_->to_coefficients.transpose() *
                        legendre_polynomials(Vec::Constant(1, 2.0 * since - 1.0), count()).row(0).transpose();
    Vec y = values_.y.middleCols(1 + panel * count(), count()) * weights;
    if (!mesh_.touches_singular_edge(static_cast<std::size_t>(panel))) return y;
    Vec from_integrals = equations_.taylor_part(left, right, values_.unknown);
    left_->add_integrals(f_, panel, since, from_integrals);
    right_->add_integrals(f_, panels() - 1 - panel, 1.0 - since, from_integrals);
    for (const auto i : algebraic_rows(*problem_)) from_integrals[i] = y[i];
    return from_integrals;
  }

  // The panel of a time, and its distance from the panel's start in lengths of the panel.
  struct Place {
    Eigen::Index panel;
    double since;
  };
  [[nodiscard]] Place place_of(double left, double right) const {
    const auto count = [](const Vec& edges, const auto& is_before) {
      return std::ranges::count_if(edges.begin() + 1, edges.end() - 1, is_before);
    };
    const bool near_start = left <= right;
    const Eigen::Index panel = near_start ? count(from_start_, [&](double edge) { return edge <= left; })
                                          : count(from_end_, [&](double edge) { return edge >= right; });
    const double length = mesh_.lengths[static_cast<std::size_t>(panel)];
    const double since =
        near_start ? (left - from_start_[panel]) / length : 1.0 - (right - from_end_[panel + 1]) / length;
    return {panel, std::clamp(since, 0.0, 1.0)};
  }

  // The sum of the last two Legendre coefficients of each column.
  [[nodiscard]] Vec last_coefficients(const Matrix& values) const {
    return (points_->to_coefficients.bottomRows<2>() * values).cwiseAbs().colwise().sum().transpose();
  }

  // The error of a row for last coefficients 1 of f: their integral on the panel. Next to a singular edge,
  // where the coefficients of a power t^p fall slowly, it is about 1/p times that; and in a row of an order
  // above 1 it acts as an error of the velocity too, which is smaller by a factor of the number of points. 0
  // for an algebraic row.
  [[nodiscard]] double unit_of_rhs(std::size_t panel, Eigen::Index row) const {
    const double order = problem_->component(row).order, length = mesh_.lengths[panel];
    if (order == 0.0) return 0.0;
    const double own = std::pow(length / 2.0, order) / std::tgamma(order + 1.0);
    if (!mesh_.touches_singular_edge(panel)) return own;
    if (order <= 1.0) return own / smallest_order(*problem_);
    return std::max(own, length * std::pow(problem_->end, order - 1.0) /
                             (std::tgamma(order) * static_cast<double>(count())));
  }

  std::shared_ptr<const Problem> problem_;
  PanelMesh mesh_;
  std::shared_ptr<const LegendrePoints> points_;
  std::shared_ptr<const PanelSide> left_, right_;
  GlobalEquations equations_;
  Vec from_start_, from_end_;  // the distances of the edges
  GridFunction values_{};
  Rows f_;
};

// The panels that are not accurate, or longer than the step limits of the problem allow, divided. Empty:
// there are none.
std::optional<PanelMesh> refined(const SolutionOnPanels& solution, const Tolerance& accuracy) {
  PanelMesh mesh = solution.mesh();
  bool is_refined = false;
  for (std::size_t k = mesh.size(); k-- > 0;) {
    const double error = solution.error(k, accuracy);
    const double start = solution.edge(static_cast<Eigen::Index>(k));
    const bool too_long = mesh.lengths[k] > 1.001 * longest_step(solution.problem(), start);
    if (error <= 1.0 && !too_long) continue;
    // Next to a singular edge the error of a row of order g falls like 4^(-g) where f is like t^g, half of
    // which remains to be divided where f is smoother.
    const double falls = 4.0 * smallest_order(solution.problem());
    const double halvings = std::isfinite(error) ? std::ceil(std::log2(std::max(error, 2.0)) / falls) : 1.0;
    divide(mesh, k, static_cast<int>(std::clamp(halvings, 1.0, static_cast<double>(most_divisions))));
    is_refined = true;
  }
  return is_refined ? std::optional(std::move(mesh)) : std::nullopt;
}

// Solves a problem on panels, from the first mesh on.
class PanelSearch {
 public:
  PanelSearch(const Problem& problem, const Tolerance& accuracy, const Options& options)
      : problem_(std::make_shared<const Problem>(problem)),
        points_(std::make_shared<const LegendrePoints>(points_for(accuracy))),
        accuracy_(accuracy),
        options_(options),
        unheard_(unheard(options)),
        run_(*problem_, unheard_) {
    constexpr double of_accuracy = 1e-4;
    unheard_.newton_tolerance =
        std::max(options.newton_tolerance, of_accuracy * std::max(accuracy.rtol, accuracy.atol));
  }

  Trajectory path() {
    auto solutions = solutions_on_first_mesh();
    std::optional<Trajectory> path;
    for (auto& solution : solutions) {
      if (!refine(solution)) continue;
      Trajectory next = recorded(solution, path ? unheard_ : options_);
      if (path) {
        path->other_solutions.push_back(std::move(next));
      } else {
        path = std::move(next);
      }
    }
    if (path) return std::move(*path);
    run_.accept(0.0, run_.start());
    if (failed_panel_ && !run_.out_of_budget()) {
      run_.fail(SolveStatus::step_too_small, *failed_panel_);
      return run_.finish();
    }
    return without_solution(run_, last_, problem_->end);
  }

 private:
  using Solution = std::shared_ptr<SolutionOnPanels>;

  static Options unheard(Options options) {
    options.observer = {};
    options.wants_past = {};
    options.events = {};
    return options;
  }

  [[nodiscard]] Solution on(PanelMesh mesh) const {
    return std::make_shared<SolutionOnPanels>(problem_, std::move(mesh), points_);
  }

  // Where no solution is found all panels are divided.
  std::vector<Solution> solutions_on_first_mesh() {
    std::vector<Solution> found;
    PanelMesh mesh = first_mesh(*problem_);
    for (int attempt = 0; attempt < most_first_meshes && found.empty(); ++attempt) {
      const Solution first = on(mesh);
      NewtonIncrements increments(first->equations());
      for (auto& end : solve_equations(first->equations(), increments, run_, unheard_)) {
        if (end.converged) {
          found.push_back(found.empty() ? first : on(mesh));
          found.back()->set(run_, std::move(end.guess));
        } else {
          last_ = std::move(end);
        }
      }
      for (std::size_t k = mesh.size(); k-- > 0;) divide(mesh, k, 2);
    }
    return found;
  }

  // Divides panels until all are accurate. Returns whether this ended with a solution.
  bool refine(Solution& solution) {
    while (auto mesh = refined(*solution, accuracy_)) {
      const auto least = std::ranges::min_element(mesh->lengths);
      if (mesh->size() > most_panels || *least < shortest * problem_->end) {
        failed_panel_ = mesh->edges()[least - mesh->lengths.begin() + 1];
        return false;
      }
      const Solution next = on(std::move(*mesh));
      NewtonIncrements increments(next->equations());
      NewtonResult end = solve_by_newton(next->equations(), increments, run_, unheard_.newton_tolerance,
                                         next->interpolated_from(*solution));
      if (!end.converged) {
        last_ = std::move(end);
        return false;
      }
      memory_ = std::max(
          memory_, increments.bytes() + next->equations().left().bytes() + next->equations().right().bytes());
      next->set(run_, std::move(end.guess));
      solution = next;
    }
    return true;
  }

  // The solution as the run of an initial value problem.
  [[nodiscard]] Trajectory recorded(const Solution& solution, const Options& options) {
    Problem posed = *problem_;
    posed.conditions = {};
    const Vec start = solution->at(0.0);
    for (std::size_t i = 0; i < posed.components.size(); ++i) {
      auto& component = posed.components[i];
      component.side = Side::left;
      component.initial.assign(initial_count(component.order), 0.0);
      component.initial.front() = start[static_cast<Eigen::Index>(i)];
    }
    Run run(posed, options);
    const double last = posed.end * (1.0 - 2e-12);  // a step that ends later counts as the last one
    if (options.wants_past) options.wants_past([solution](double t, Out y) { y = solution->at(t); });
    const StepInterpolant within{.at = [&](double t) { return solution->at(t); },
                                 .pieces = static_cast<int>(points_->points.size())};
    for (Eigen::Index k = 1; k <= solution->panels(); ++k) {
      const double t = solution->edge(k);
      if (k < solution->panels() && t > last) continue;
      if (!run.accept(t, solution->at(t), &within)) break;
    }
    Trajectory path = run.finish();
    path.dense_output = [solution](double t) { return solution->at(t); };
    path.cost.rhs_calls = run_.cost().rhs_calls;
    path.cost.newton_iterations = run_.cost().newton_iterations;
    path.cost.history_bytes = memory_;
    return path;
  }

  std::shared_ptr<const Problem> problem_;
  std::shared_ptr<const LegendrePoints> points_;
  Tolerance accuracy_;
  const Options& options_;
  Options unheard_;  // for the search: without what is wanted of the run
  Run run_;
  NewtonResult last_{};                   // of Newton's method that did not converge
  std::optional<double> failed_panel_{};  // the time of a panel that is not accurate
  std::size_t memory_ = 0;
};

}  // namespace

Trajectory solve_on_panels(const Problem& problem, const Tolerance& accuracy, const Options& options) {
  return PanelSearch(problem, accuracy, options).path();
}

}  // namespace fde
