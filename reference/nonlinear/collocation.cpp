// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/collocation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fdebench/reference/nonlinear/collocation/piecewise_solution.hpp"
#include "fdebench/reference/nonlinear/collocation/residual.hpp"
#include "fdebench/reference/nonlinear/diffusive/diffusive_solution.hpp"
#include "fdebench/reference/nonlinear/error_estimates.hpp"
#include "fdebench/reference/nonlinear/march/jumps.hpp"
#include "fdebench/reference/nonlinear/march/rhs_at.hpp"
#include "fdebench/reference/nonlinear/march/supported_problem.hpp"
#include "fdebench/schemes/problem/breaking_points.hpp"
#include "fdebench/schemes/problem/multipliers.hpp"

namespace fde::reference {

namespace {

// Both methods solve dense linear systems for all values of a panel or a step: one minute for 100 unknowns,
// eight times as long for 200.
void require_affordable(const Problem& problem) {
  constexpr Eigen::Index max_unknowns = 200;
  if (problem.size() <= max_unknowns) return;
  throw std::runtime_error(fmt::format("the two methods of a reference take up to {} unknowns, not {}",
                                       max_unknowns, problem.size()));
}

// Lengths of the first panel and the first step, and PanelOptions::negligible_before, relative to the end.
struct InitialLengths {
  double panel = 1e-32, step = 1e-20, weightless = 1e-18;
};

// The length, relative to the end, of a first panel on which y hardly changes: there Newton's method, which
// starts from y(0), finds the root that continues it. A solution of D^g y = -k y^2 with a small g is far from
// y(0) soon after 0, and the equations of a longer panel have other roots. Not below 1e-290: the residual
// shows whether that is short enough.
double length_of_small_change(const Problem& problem) {
  constexpr double small = 0.1, shortest = 1e-290;
  Matrix jacobian(problem.size(), problem.size());
  double length = 1.0;
  if (!evaluate_jacobian(problem, 0.0, taylor_part(problem, 0.0), jacobian) || !jacobian.allFinite())
    return length;
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const double order = problem.components[static_cast<std::size_t>(i)].order;
    const double rate = jacobian.row(i).cwiseAbs().sum() / std::tgamma(order + 1.0);
    if (order > 0.0 && rate > 0.0)
      length = std::min(length, std::pow(small / rate, 1.0 / order) / problem.end);
  }
  return std::max(length, shortest);
}

// A solution starts like t^g, g the smallest order, and the first panel approximates it by a polynomial. That
// error is below rounding if the panel is short enough, or it decays within some decades: before the first
// step of a grid, which is at least N^-10 of the end, 6e-58 for 2^19 steps. With multipliers it must be below
// rounding, since the constraint propagates it to all components. For the second method, whose constraint
// determines the reaction, t^(2 g) remains.
InitialLengths initial_lengths(const Problem& problem) {
  constexpr double rounding = 1e-17, before_grids = 1e-66, early = 1e-6, shortest = 1e-270;
  double order = 1.0;
  for (const auto& component : problem.components) {
    if (!is_algebraic(component)) order = std::min(order, component.order);
  }
  InitialLengths usual;
  const double unseen = std::min(usual.panel, std::pow(rounding, 1.0 / order));
  if (std::ranges::none_of(problem.components, is_algebraic)) {
    usual.panel = std::min(std::max(unseen, before_grids), length_of_small_change(problem));
    return usual;
  }
  const InitialLengths starts{.panel = unseen,
                              .step = std::min(usual.step, std::pow(rounding, 0.5 / order)),
                              .weightless = std::min(usual.weightless, std::pow(early, 1.0 / order))};
  if (starts.panel < shortest) {
    throw std::runtime_error(
        fmt::format("collocation: takes no order below {:.2g} with algebraic rows, one is {:.3g}",
                    std::log(rounding) / std::log(shortest), order));
  }
  return starts;
}

// Bound of the initial values: infinite for the multipliers, which are in no algebraic row, or, where the
// algebraic rows do not hold at t = 0, for the unknowns of all algebraic rows.
Vec initial_bound(const Problem& problem) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), rounding = 1e-14;
  Vec bound = Vec::Zero(problem.size());
  if (std::ranges::none_of(problem.components, is_algebraic)) return bound;
  const Vec start = taylor_part(problem, 0.0), f = rhs_at(problem, 0.0, start);
  const double size = std::max(1.0, start.lpNorm<Eigen::Infinity>());
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < problem.size(); ++i)
    if (is_algebraic(problem.components[static_cast<std::size_t>(i)])) rows.push_back(i);
  const bool held = std::ranges::all_of(rows, [&](auto i) { return std::abs(f[i]) <= rounding * size; });
  for (const auto i : held ? multipliers(problem) : rows) bound[i] = infinity;
  return bound;
}

PanelTable table_of(const Problem& problem, const CollocationOptions& options) {
  const InitialLengths starts = initial_lengths(problem);
  const auto solve = [&](int points, double shortest) -> PiecewiseSolution {
    return {problem,
            {.points = points,
             .first_panel = shortest * starts.panel,
             .first_after_jump = shortest * first_after_jump,
             .tolerance = options.tolerance,
             .negligible_before = starts.weightless}};
  };
  const auto solution = solve(20, 1.0);
  require_small_residual(problem, solution);
  const auto other = solve(16, 3.0);
  const auto second =
      diffusive_solution(problem, {.first_step = starts.step, .negligible_before = starts.weightless});
  const auto estimates = error_estimates(problem, solution, other, second);
  PanelTable table;
  for (const Panel& panel : solution.panels()) {
    table.panels.push_back(
        {panel.from, panel.to, solution.legendre_values(panel), estimates[table.panels.size()]});
  }
  return table;
}

}  // namespace

Reference reference_from_table(PanelTable table, const Problem& problem) {
  return reference_from_panels(std::move(table), initial_bound(problem));
}

PanelTable reference_table(const Problem& problem, const CollocationOptions& options) {
  require_supported(problem);
  require_affordable(problem);
  // Polynomials resolve a kink no better than a jump.
  Problem broken = problem;
  broken.jump_times = breaking_points(problem);
  return table_of(broken, options);
}

Reference reference_solution(const Problem& problem, const CollocationOptions& options) {
  return reference_from_table(reference_table(problem, options), problem);
}

}  // namespace fde::reference
