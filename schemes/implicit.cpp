#include "implicit.hpp"

namespace fde {

ImplicitRule integral_rule(const Problem& problem, WeightFamily family) {
  return {.tables = tables(problem, family),
          .past =
              [taylor = TaylorPart(problem)](double t, In convolved, In /*previous*/, In kappa, Out past) {
                taylor.at(t, past);
                past += kappa.cwiseProduct(convolved);
              },
          .sample = [](Run& run, double t, In y, In /*previous*/, Out sample) { sample = run.rhs(t, y); }};
}

Trajectory solve_implicit(const Problem& problem, const Grid& grid, const Options& options,
                          const ImplicitRule& rule) {
  Run run(problem, grid, options);
  NewtonSolver newton(problem, options.tolerance);
  StepFactors factors(rule.tables, grid);
  const auto history = make_history(options.history, {rule.tables}, grid, options.tolerance);
  run.cost().history_bytes = history->bytes();

  Vec previous = run.start(), y = previous, sample(y.size()), convolved(y.size()), past(y.size());
  rule.sample(run, 0.0, y, previous, sample);
  for (int n = 1; n <= grid.steps; ++n) {
    const double t = grid.time(n);
    history->push(sample);
    history->convolve(0, convolved);
    const Vec& kappa = factors.at(n);
    rule.past(t, convolved, previous, kappa, past);
    if (!newton.solve(run, t, kappa, past, y)) {
      run.fail(y.allFinite() ? Outcome::not_converged : Outcome::not_finite);
      break;
    }
    if (!run.accept(n, y)) break;
    if (n < grid.steps) rule.sample(run, t, y, previous, sample);
    previous = y;
  }
  return run.finish();
}

}  // namespace fde
