#pragma once

#include "history/history.hpp"
#include "history/running_sum.hpp"

namespace fde {

// The sum as it stands, O(n) work at step n: one long dot product a component, over contiguous samples and
// weights stored reversed. Components whose weights are all equal (order 1) keep a running sum instead of
// their past.
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
  // How one component enters one sum: a running sum with constant weights, or a dot product with a column of
  // weights.
  struct Part {
    double start, constant;  // of x_0, of all other samples
    Eigen::Index column;     // of weights_ and starts_; -1: constant
  };
  static Part part(const WeightTable& table, std::vector<WeightTable>& distinct);

  Eigen::Index steps_;
  Eigen::Index pushed_ = 0;
  std::vector<std::vector<Part>> parts_;  // [sum][component]
  std::vector<Eigen::Index> row_;  // column of samples_ that a component owns; -1: only its running sum
  Matrix weights_;                 // one column a distinct table: w(steps), ..., w(1)
  Matrix starts_;                  // the same tables: start_weight(1), ..., start_weight(steps)
  Matrix samples_;                 // one column a component with memory
  Vec first_;                      // x_0
  RunningSums totals_;             // of x_1, x_2, ...
};

}  // namespace fde
