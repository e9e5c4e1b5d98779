// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/history.hpp"

namespace fde {

// Direct summation on equal steps, O(n) work at step n: one dot product a component, over contiguous samples
// and weights stored in reverse. Components whose weights are all equal (order 1) need a running sum only.
class DirectHistory final : public History {
 public:
  DirectHistory(const WeightTables& tables, int steps);
  [[nodiscard]] std::unique_ptr<History> copy() const override {
    return std::make_unique<DirectHistory>(*this);
  }
  void push(double t, In sample) override;
  void convolve(double t, std::size_t sum, Out result) const override;
  [[nodiscard]] std::size_t bytes() const override;
  void state(Archive& archive) override;

 private:
  // One component in one sum: constant weights (a running sum), or a column of weights (a dot product).
  struct Part {
    double start, constant;  // the weight of x_0 and of all other samples
    Eigen::Index column;     // in weights_ and starts_; -1: the weights are constant
  };
  static Part part(const WeightTable& table, std::vector<WeightTable>& distinct);

  Eigen::Index steps_;
  Eigen::Index pushed_ = 0;
  std::vector<std::vector<Part>> parts_;  // [sum][component]
  std::vector<Eigen::Index> row_;         // column of samples_ of each component; -1: only a running sum
  Matrix weights_;                        // one column a distinct table: w(steps), ..., w(1)
  Matrix starts_;   // one column a distinct table: first_sample_weight(1), ..., first_sample_weight(steps)
  Matrix samples_;  // one column a component that is not only a running sum
  Vec first_;       // x_0
  RunningSums totals_;  // of x_1, x_2, ...
};

}  // namespace fde
