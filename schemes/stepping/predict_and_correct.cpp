// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/predict_and_correct.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/stepping/grid_stepper.hpp"

namespace fde {

namespace {

std::vector<WeightTable> joined(std::vector<WeightTable> first, const std::vector<WeightTable>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

class PredictorCorrector final : public GridStepper<PredictorCorrector> {
 public:
  PredictorCorrector(const Problem& problem, const Grid& grid, const Options& options)
      : PredictorCorrector(problem, grid, options, weight_tables(problem, families::rectangle),
                           weight_tables(problem, families::trapezoid)) {}

  SolveStatus step() {
    const Eigen::Index size = y_.size();
    run_.rhs(before(), solution_, f_);
    history_->push(before(), sample_);
    history_->convolve(t(), 0, predicted_);
    history_->convolve(t(), 1, corrected_);
    if (has_velocities_) taylor_part_.at(t(), taylor_);
    const double* const kappa = factors_.at(h()).data();
    for_each_row(size, [=, part = taylor_.data(), sum = predicted_.data(), to = y_.data()](Eigen::Index i) {
      to[i] = part[i] + kappa[i] * sum[i];
    });
    const bool jump = jumps().correct(t(), y_, before_jump_, [&](double time) {
      for (int correction = 0; correction < options_.corrections; ++correction) {
        run_.rhs(time, solution_, f_);
        for_each_row(size,
                     [=, part = taylor_.data(), sum = corrected_.data(), newest = f_.data(), to = y_.data()](
                         Eigen::Index i) { to[i] = part[i] + kappa[size + i] * (sum[i] + newest[i]); });
      }
    });
    result_ = jump ? &before_jump_ : &y_;
    return SolveStatus::finished;
  }

  void rule_state(Archive& archive) { archive(*history_); }

 private:
  PredictorCorrector(const Problem& problem, const Grid& grid, const Options& options,
                     const std::vector<WeightTable>& predictor, const std::vector<WeightTable>& corrector)
      : GridStepper(problem, grid, options),
        has_velocities_(
            std::ranges::any_of(problem.components, [](const auto& row) { return row.order > 1.0; })),
        taylor_part_(problem),
        history_(
            make_history(options.history, {predictor, corrector}, step_plan(grid), options.newton_tolerance)),
        factors_(joined(predictor, corrector)),
        f_(y_.size()),
        predicted_(y_.size()),
        corrected_(y_.size()),
        taylor_(y_.size()) {
    record_history(history_->bytes(), history_->chosen());
    taylor_part_.at(0.0, taylor_);
  }

  const bool has_velocities_;  // the Taylor part depends on t
  const TaylorPart taylor_part_;
  const std::unique_ptr<History> history_;
  StepFactors factors_;
  Vec before_jump_{}, f_, predicted_, corrected_, taylor_;
  // Made once: a view takes as long as a component.
  const Eigen::Ref<const Vec> sample_{f_};
};

}  // namespace

Trajectory predict_and_correct(const Problem& problem, const Grid& grid, const Options& options) {
  return integrate(PredictorCorrector(problem, grid, options));
}

// The predictor takes f constant: where f starts like t, it has the error h^(1+g), and y has h^g times that.
const RateTheory predictor_corrector_theory{
    [](double g) { return std::min(2.0, 1 + g); }, end_rate_of_interpolated_f,
    [](double g, double p) {
      return same_order(p - g, 1.0) ? 2 * g + 1 : first_step_rate_of_interpolated_f(g, p);
    }};

}  // namespace fde
