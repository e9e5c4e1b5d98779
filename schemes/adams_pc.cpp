#include "adams_pc.hpp"

#include "rates.hpp"
#include "run.hpp"

namespace fde {

Trajectory predict_and_correct(const Problem& problem, const Grid& grid, const Options& options) {
  Run run(problem, grid, options);
  const Vec predictor_scale = integral_scale(problem, grid.step(), 1.0);
  const Vec corrector_scale = integral_scale(problem, grid.step(), 2.0);
  const auto history = make_history(
      options.history, {tables(problem, WeightFamily::rectangle), tables(problem, WeightFamily::trapezoid)},
      grid.steps);
  run.cost().history_bytes = history->bytes();

  Vec y = run.start(), predicted(y.size()), corrected(y.size());
  for (int n = 1; n <= grid.steps; ++n) {
    history->push(run.rhs(grid.time(n - 1), y));
    history->convolve(0, predicted);
    history->convolve(1, corrected);
    const double t = grid.time(n);
    const Vec taylor = taylor_part(problem, t);
    y = taylor + predictor_scale.cwiseProduct(predicted);
    for (int correction = 0; correction < options.corrections; ++correction) {
      y = taylor + corrector_scale.cwiseProduct(corrected + run.rhs(t, y));
    }
    if (!run.accept(n, y)) break;
  }
  return run.finish();
}

Scheme adams_pc() {
  return {
      .id = "adams_pc",
      .title = "Fractional Adams predictor-corrector",
      .source = "Diethelm, Ford & Freed, Nonlinear Dynamics 29 (2002); Numerical Algorithms 36 (2004)",
      .needs = {},
      .expected_rate = [](const Problem& problem, const Smoothness& smoothness,
                          Norm norm) { return rate(predictor_corrector_theory, problem, smoothness, norm); },
      .solve = predict_and_correct};
}

}  // namespace fde
