// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/interpolants/slope_history.hpp"

namespace fde {

SlopeHistory::SlopeHistory(const std::vector<WeightTable>& tables, const StepPlan& steps,
                           const Options& options)
    : steps_(steps),
      factors_(tables),
      history_(make_history(options.history, {tables}, steps, options.tolerance)) {}

void SlopeHistory::push(double t, In sample) {
  history_->push(t, sample);
  newest_ = t;
}

// The sums of a history are scaled with the step factor of the step to t with variable steps, of the constant
// step otherwise.
void SlopeHistory::derivative(double t, Out result) {
  history_->convolve(t, 0, result);
  result.array() /= factors_.at(steps_.uniform ? steps_.min_step : t - newest_).array();
}

}  // namespace fde
