// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/global_solver.hpp"

#include <algorithm>
#include <utility>

#include "fdebench/schemes/problem/initial_guess.hpp"
#include "fdebench/schemes/rules/two_sided/stepped_side.hpp"
#include "fdebench/schemes/rules/two_sided/two_grid_solver.hpp"

namespace fde {
namespace {

constexpr int search_steps = 64, starts = 64;
constexpr double search_tolerance = 1e-8;

// Whether both are the same solution, up to the tolerance of a search.
bool alike(const GridFunction& a, const GridFunction& b) {
  return (a.y - b.y).norm() <= 1e3 * search_tolerance * (a.y.norm() + b.y.norm());
}

// The mean of |y|^2 over time, times the end.
double size(const Vec& times, const Rows& y) {
  double sum = 0.0;
  for (Eigen::Index n = 1; n < times.size(); ++n)
    sum += (times[n] - times[n - 1]) / 2 * (y.col(n - 1).squaredNorm() + y.col(n).squaredNorm());
  return sum;
}

// The solutions on a coarse grid to which Newton's method converges from the Taylor part and from other
// starts, the smallest first.
std::vector<GridFunction> coarse_solutions(const GlobalEquations& equations, Run& run) {
  NewtonIncrements increments(equations, NewtonIncrements::First::two_grid);
  const Vec& times = equations.discretisation().left;
  std::vector<GridFunction> found;
  const auto add_from = [&](GridFunction start) {
    NewtonResult end = solve_by_newton(equations, increments, run, search_tolerance, std::move(start));
    const auto known = [&](const GridFunction& solution) { return alike(solution, end.guess); };
    if (end.converged && std::ranges::none_of(found, known)) found.push_back(std::move(end.guess));
  };
  add_from(equations.initial_guess());
  for (const auto& other : initial_guesses(equations.problem(), starts)) {
    if (run.out_of_budget()) break;
    GridFunction start = equations.initial_guess();
    for (Eigen::Index n = 0; n < times.size(); ++n) start.y.col(n) = other.at(times[n]);
    add_from(std::move(start));
  }
  std::ranges::sort(found, {}, [&](const GridFunction& solution) { return size(times, solution.y); });
  return found;
}

// The solutions on the whole grid to which Newton's method converges from the coarse ones; the first one
// only, unless all are requested.
std::vector<NewtonResult> solutions(const GlobalEquations& equations, NewtonIncrements& increments, Run& run,
                                    const Options& options) {
  const GlobalEquations coarse = equations.with_steps(search_steps);
  std::vector<NewtonResult> found;
  for (auto& solution : coarse_solutions(coarse, run)) {
    solution.y =
        interpolate_linearly(coarse.discretisation().left, solution.y, equations.discretisation().left);
    NewtonResult end =
        solve_by_newton(equations, increments, run, options.newton_tolerance, std::move(solution));
    if (end.converged) found.push_back(std::move(end));
    if (!found.empty() && !options.all_solutions) break;
  }
  return found;
}

}  // namespace

std::vector<NewtonResult> solve_equations(const GlobalEquations& equations, NewtonIncrements& increments,
                                          Run& run, const Options& options) {
  const auto& problem = equations.problem();
  NewtonResult end =
      solve_by_newton(equations, increments, run, options.newton_tolerance, equations.initial_guess());
  std::vector<NewtonResult> found;
  if (is_two_sided(problem) && (options.all_solutions || (!end.converged && !is_linear(problem))))
    found = solutions(equations, increments, run, options);
  if (found.empty()) found.push_back(std::move(end));
  return found;
}

Trajectory without_solution(Run& run, const NewtonResult& end, double first_time) {
  if (run.out_of_budget()) {
    run.fail(SolveStatus::out_of_budget, first_time);
  } else {
    run.fail_without_convergence(end.residual);
  }
  return run.finish();
}

Trajectory solve_globally(const Problem& problem, const Grid& grid, const Options& options,
                          const WeightFamily& family) {
  Run run(problem, options, grid.steps);
  const GlobalEquations equations(problem, discretisation_by_steps(problem, grid, options, family));
  NewtonIncrements increments(equations);
  const auto found = solve_equations(equations, increments, run, options);
  const auto& end = found.front();
  const auto values = 8 * end.guess.y.size();  // guesses, residuals and increments
  run.cost().history = equations.left().history();
  if (!run.cost().history) run.cost().history = equations.right().history();
  run.cost().history_bytes = equations.left().bytes() + equations.right().bytes() + increments.bytes() +
                             sizeof(double) * static_cast<std::size_t>(values);
  if (!end.converged) {
    // The initial value is recorded, as in every run that fails at its first step.
    if (is_two_sided(problem)) run.accept(0.0, run.start());
    return without_solution(run, end, grid.time(1));
  }
  const int first = is_two_sided(problem) ? 0 : 1;
  for (int n = first; n <= grid.steps && run.accept(grid.time(n), end.guess.y.col(n)); ++n) continue;
  Trajectory path = run.finish();
  Options unheard = options;
  unheard.observer = {};
  for (std::size_t k = 1; k < found.size(); ++k) {
    Run other(problem, unheard, grid.steps);
    for (int n = 0; n <= grid.steps && other.accept(grid.time(n), found[k].guess.y.col(n)); ++n) continue;
    path.other_solutions.push_back(other.finish());
  }
  return path;
}

}  // namespace fde
