// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/weights/step_factors.hpp"
#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// The Caputo derivative of an interpolant whose slope on each step is determined by one sample, by a family
// of weights for increments. Times as in History.
class SlopeHistory {
 public:
  SlopeHistory(const std::vector<WeightTable>& tables, const StepPlan& steps, const Options& options);

  void push(double t, In sample);

  // The contribution of all samples to the derivative at a time t after the newest.
  void derivative(double t, Out result);

  [[nodiscard]] std::size_t bytes() const { return history_->bytes(); }
  [[nodiscard]] HistoryKind kind() const { return history_->kind(); }

  void state(Archive& archive) { archive(newest_, history_); }

 private:
  StepPlan steps_;
  double newest_ = 0.0;  // time of the newest sample
  StepFactors factors_;
  std::unique_ptr<History> history_;
};

}  // namespace fde
