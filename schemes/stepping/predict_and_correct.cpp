#include "stepping/predict_and_correct.hpp"

#include "stepping/run.hpp"
#include "weights/step_factors.hpp"

namespace fde {

Trajectory predict_and_correct(const Problem& problem, const Grid& grid, const Options& options) {
  Run run(problem, options, grid.steps);
  const auto predictor = tables(problem, families::rectangle);
  const auto corrector = tables(problem, families::trapezoid);
  const auto history =
      make_history(options.history, {predictor, corrector}, step_plan(grid), options.tolerance);
  run.cost().history_bytes = history->bytes();
  const TaylorPart taylor_part(problem);
  auto of_both = predictor;
  of_both.insert(of_both.end(), corrector.begin(), corrector.end());
  StepFactors factors(of_both);

  Vec y = run.start(), predicted(y.size()), corrected(y.size()), taylor(y.size());
  double t = 0.0;
  int n = 1;
  const State state = [&](Archive& archive) {
    archive.count(n, 1, grid.steps);
    archive(t, y, *history);
  };
  for (run.resume(state); n <= grid.steps; ++n) {
    run.offer(state);
    history->push(t, run.rhs(t, y));
    const double before = t;
    t = grid.time(n);
    history->convolve(t, 0, predicted);
    history->convolve(t, 1, corrected);
    taylor_part.at(t, taylor);
    const Vec& kappa = factors.at(grid.step(before, t));
    y = taylor + kappa.head(y.size()).cwiseProduct(predicted);
    for (int correction = 0; correction < options.corrections; ++correction) {
      y = taylor + kappa.tail(y.size()).cwiseProduct(corrected + run.rhs(t, y));
    }
    if (!run.accept(t, y)) break;
  }
  return run.finish();
}

}  // namespace fde
