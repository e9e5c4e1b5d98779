// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/multi_term/multi_term_solvers.hpp"

#include <utility>

#include "fdebench/schemes/rules/implicit/newton.hpp"
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"
#include "fdebench/schemes/stepping/grid_jumps.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {
namespace {

// The first steps of a rule with starting weights, one column each.
Matrix first_steps_of(Run& run, IntegratedEquations& equations, const Problem& problem,
                      const Problem& stepped, const Grid& grid, double tolerance, SolveStatus& ending) {
  auto system = equations.first_equations();
  if (!system) {
    ending = SolveStatus::step_too_large;
    return {};
  }
  const auto first_order = [&](const Grid& steps, const Options& exact) {
    return solve_integrated_equations(problem, steps, exact, families::grunwald_letnikov);
  };
  return StartingProcedure(stepped, grid, std::move(*system), first_order).solve(run, tolerance, ending);
}

}  // namespace

Trajectory solve_integrated_equations(const Problem& problem, const Grid& grid, const Options& options,
                                      const WeightFamily& family) {
  std::vector<double> powers;  // none without starting weights
  if (family.multistep != nullptr)
    powers = starting_powers_of_equations(family, problem).for_steps(grid.steps);
  const Problem stepped = integrated_problem(problem);
  Run run(stepped, options, grid.steps);
  NewtonSolver newton(stepped, options.tolerance);
  const GridJumps jumps(problem, grid);
  IntegratedEquations equations(problem, family, grid, options, powers);
  run.cost().history_bytes = equations.bytes();
  run.cost().history = name(equations.history_kind());
  if (!powers.empty()) run.cost().starting_weights = static_cast<int>(powers.size());

  Matrix first;
  SolveStatus ending = SolveStatus::finished;
  Vec y = run.start();
  double t = 0.0;
  int n = 1;
  const StateArchiver state = [&](Archive& archive) {
    archive.count(n, 1, grid.steps);
    archive(t, y, newton, equations);
    archive.resizable(first);
  };
  if (!run.resume_from_checkpoint(state) && powers.size() > 1)
    first = first_steps_of(run, equations, problem, stepped, grid, options.tolerance, ending);
  for (; n <= grid.steps && ending == SolveStatus::finished; ++n) {
    run.offer_checkpoint(state);
    equations.push(t, y, newton.rhs_at_solution(run, t, y));
    t = grid.time(n);
    if (n <= first.cols()) {
      y = first.col(n - 1);
    } else {
      ending = SolveStatus::step_too_large;
      if (equations.prepare_step(n))
        ending = newton.solve(run, {t, equations.kappa(), equations.known(), jumps.before(t)}, y);
    }
    if (ending == SolveStatus::finished && !run.accept(t, newton.delivered(y))) return run.finish();
  }
  if (ending != SolveStatus::finished) run.fail(ending, t > 0.0 ? t : grid.time(1));
  return run.finish();
}

Trajectory predict_and_correct_equations(const Problem& problem, const Grid& grid, const Options& options) {
  const Problem stepped = integrated_problem(problem);
  Run run(stepped, options, grid.steps);
  IntegratedEquations equations(problem, families::trapezoid, grid, options);
  run.cost().history_bytes = equations.bytes();
  run.cost().history = name(equations.history_kind());

  const GridJumps jumps(problem, grid);
  Vec y = run.start(), delivered, f = Vec::Zero(y.size()), before = f;
  double t = 0.0;
  int n = 1;
  const StateArchiver state = [&](Archive& archive) {
    archive.count(n, 1, grid.steps);
    archive(t, y, f, equations);
  };
  for (run.resume_from_checkpoint(state); n <= grid.steps; ++n) {
    run.offer_checkpoint(state);
    before = f;
    f = run.rhs(t, y);
    equations.push(t, y, f);
    t = grid.time(n);
    if (!equations.prepare_step(n)) {
      run.fail(SolveStatus::step_too_large, t);
      break;
    }
    const double ratio = n == 1 ? 0.0 : grid.step(n) / grid.step(n - 1);
    if (n == 1) before = f;
    y = equations.known() + equations.kappa().cwiseProduct(f + ratio * (f - before));
    const auto correct = [&](double time) {
      for (int correction = 0; correction < options.corrections; ++correction)
        y = equations.known() + equations.kappa().cwiseProduct(run.rhs(time, y));
    };
    const bool jump = jumps.correct(t, y, delivered, correct);
    if (!run.accept(t, jump ? delivered : y)) break;
  }
  return run.finish();
}

}  // namespace fde
