#include "implicit.hpp"

namespace fde {

ImplicitRule integral_rule(const Problem& problem, const Vec& kappa, WeightFamily family) {
  return {
      .kappa = kappa,
      .tables = tables(problem, family),
      .past = [&problem, kappa](double t, In convolved, In /*previous*/,
                                Out past) { past = taylor_part(problem, t) + kappa.cwiseProduct(convolved); },
      .sample = [](Run& run, double t, In y, In /*previous*/, Out sample) { sample = run.rhs(t, y); }};
}

Trajectory solve_implicit(const Problem& problem, const Grid& grid, const Options& options,
                          const ImplicitRule& rule) {
  Run run(problem, grid, options);
  NewtonSolver newton(problem, rule.kappa, options.tolerance);
  const auto history = make_history(options.history, {rule.tables}, grid.steps);
  run.cost().history_bytes = history->bytes();

  Vec previous = run.start(), y = previous, sample(y.size()), convolved(y.size()), past(y.size());
  rule.sample(run, 0.0, y, previous, sample);
  for (int n = 1; n <= grid.steps; ++n) {
    const double t = grid.time(n);
    history->push(sample);
    history->convolve(0, convolved);
    rule.past(t, convolved, previous, past);
    if (!newton.solve(run, t, past, y)) {
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
