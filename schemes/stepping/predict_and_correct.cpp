// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/predict_and_correct.hpp"

#include <algorithm>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/stepping/grid_jumps.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

Trajectory predict_and_correct(const Problem& problem, const Grid& grid, const Options& options) {
  Run run(problem, options, grid.steps);
  const auto predictor = weight_tables(problem, families::rectangle);
  const auto corrector = weight_tables(problem, families::trapezoid);
  const auto history =
      make_history(options.history, {predictor, corrector}, step_plan(grid), options.newton_tolerance);
  run.cost().history_bytes = history->bytes();
  run.cost().history = name(history->kind());
  const TaylorPart taylor_part(problem);
  auto of_both = predictor;
  of_both.insert(of_both.end(), corrector.begin(), corrector.end());
  StepFactors factors(of_both);

  const Eigen::Index size = problem.size();
  const GridJumps jumps(problem, grid);
  Vec y = run.start(), delivered, f(y.size()), predicted(y.size()), corrected(y.size()), taylor(y.size());
  const Eigen::Ref<const Vec> solution(y), sample(f);  // made once: a view takes as long as a component
  const bool moves =
      std::ranges::any_of(problem.components, [](const auto& component) { return component.order > 1.0; });
  double t = 0.0;
  taylor_part.at(t, taylor);
  int n = 1;
  const StateArchiver state = [&](Archive& archive) {
    archive.count(n, 1, grid.steps);
    archive(t, y, *history);
  };
  for (run.resume_from_checkpoint(state); n <= grid.steps; ++n) {
    run.offer_checkpoint(state);
    run.rhs(t, solution, f);
    history->push(t, sample);
    const double before = t;
    t = grid.time(n);
    history->convolve(t, 0, predicted);
    history->convolve(t, 1, corrected);
    if (moves) taylor_part.at(t, taylor);
    const double* const kappa = factors.at(grid.step(before, t)).data();
    for_each_row(size, [=, part = taylor.data(), sum = predicted.data(), to = y.data()](Eigen::Index i) {
      to[i] = part[i] + kappa[i] * sum[i];
    });
    const auto correct = [&](double time) {
      for (int correction = 0; correction < options.corrections; ++correction) {
        run.rhs(time, solution, f);
        for_each_row(size,
                     [=, part = taylor.data(), sum = corrected.data(), newest = f.data(), to = y.data()](
                         Eigen::Index i) { to[i] = part[i] + kappa[size + i] * (sum[i] + newest[i]); });
      }
    };
    const bool jump = jumps.correct(t, y, delivered, correct);
    if (!(jump ? run.accept(t, delivered) : run.accept(t, solution))) break;
  }
  return run.finish();
}

// The predictor takes f constant: where f starts like t, it has the error h^(1+g), and y has h^g times that.
const RateTheory predictor_corrector_theory{
    [](double g) { return std::min(2.0, 1 + g); }, end_rate_of_interpolated_f,
    [](double g, double p) {
      return same_order(p - g, 1.0) ? 2 * g + 1 : first_step_rate_of_interpolated_f(g, p);
    }};

}  // namespace fde
