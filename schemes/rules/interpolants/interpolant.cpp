// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/interpolants/interpolant.hpp"

#include "fdebench/schemes/rules/implicit/newton.hpp"
#include "fdebench/schemes/rules/interpolants/off_step_problem.hpp"
#include "fdebench/schemes/stepping/grid_jumps.hpp"

namespace fde {

Trajectory solve_with_interpolant(Interpolant& interpolant, const Problem& problem, const Grid& grid,
                                  const Options& options) {
  OffStepProblem stepped(problem, interpolant.offsets());
  Run run(stepped.problem(), options, grid.steps);
  NewtonSolver newton(stepped.problem(), options.tolerance);
  const GridJumps jumps(problem, grid);
  run.cost().history_bytes = interpolant.bytes();
  run.cost().history = name(interpolant.history_kind());

  Vec y = run.start(), before = y, known_derivative(y.size()), newest(y.size()), kappa(y.size()),
      known(y.size());
  int n = 1;
  const StateArchiver state = [&](Archive& archive) {
    archive.count(n, 1, grid.steps);
    archive(y, newton, interpolant);
  };
  for (run.resume_from_checkpoint(state); n <= grid.steps; ++n) {
    run.offer_checkpoint(state);
    const double t = grid.time(n);
    before = y;
    stepped.set_step(grid.time(n - 1), before, grid.step(n));
    interpolant.derivative(n, known_derivative, newest);
    kappa = newest.cwiseInverse();
    known = before - kappa.cwiseProduct(known_derivative);
    if (const SolveStatus ending = newton.solve(run, {t, kappa, known, jumps.before(t)}, y);
        ending != SolveStatus::finished) {
      run.fail(ending, t);
      break;
    }
    if (!run.accept(t, newton.delivered(y))) break;
    if (n < grid.steps) interpolant.push(n, y - before);
  }
  *run.cost().rhs_calls *= stepped.evaluations();
  return run.finish();
}

}  // namespace fde
