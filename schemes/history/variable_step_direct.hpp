// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/history.hpp"

namespace fde {

// Direct summation on variable steps: fractional integrals of piecewise linear functions
// (interval_weights.hpp), scaled so that the new sample has weight 1. On equal steps these are the sums of
// DirectHistory. All weights are recomputed for every candidate time, O(n) powers at step n.
class VariableStepDirectHistory final : public History {
 public:
  VariableStepDirectHistory(const WeightTables& tables, const StepPlan& steps);
  [[nodiscard]] std::unique_ptr<History> copy() const override {
    return std::make_unique<VariableStepDirectHistory>(*this);
  }
  void push(double t, In sample) override;
  void convolve(double t, std::size_t sum, Out result) const override;
  [[nodiscard]] HistoryKind kind() const override { return HistoryKind::direct; }
  [[nodiscard]] std::size_t bytes() const override;
  void state(Archive& archive) override;

 private:
  // The weights of all steps up to the candidate time, for one order of integration.
  struct Integral {
    double order;
    Vec left, right;
  };
  // The quantities of the last candidate time, cached.
  struct StepCache {
    std::optional<double> time{};
    std::vector<Integral> integrals{};
  };
  // One component in one sum.
  struct ComponentSum {
    Eigen::Index component;
    WeightTable table;
    std::size_t integral;
  };
  void reserve(Eigen::Index steps);
  // The end of the step from sample j; t for the candidate step.
  [[nodiscard]] double end_of_step(std::size_t j, double t) const;
  [[nodiscard]] const StepCache& candidate(double t) const;

  std::vector<double> times_;                      // of the samples
  Matrix samples_;                                 // one row a time, then rows of zeros
  std::vector<std::vector<ComponentSum>> tracks_;  // of each sum; only components with a memory term
  mutable StepCache candidate_;
};

}  // namespace fde
