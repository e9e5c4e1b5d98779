// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/history/weights/weights.hpp"

namespace fde {

// Computes the step factors kappa of several tables for varying step lengths. Gamma functions are computed
// once, one power for each distinct order and length, and nothing where the length is unchanged.
class StepFactors {
 public:
  explicit StepFactors(const std::vector<WeightTable>& tables);

  // The step factors for this length, one a table. The reference is valid until the next call.
  const Vec& at(double length) {
    if (length != length_) compute(length);
    return factors_;
  }

  // length^exponent with the length of the last call; cached where the exponent is an order of a table.
  [[nodiscard]] double power(double exponent) const;

 private:
  // One of the tables, each once.
  struct Table {
    WeightTable table;
    Eigen::Index order;  // its index in orders_
    long double unit;    // the factor for length 1
  };

  void compute(double length);

  std::vector<double> orders_;  // each once
  std::vector<Table> distinct_;
  std::vector<Eigen::Index> of_row_;  // for each table its index in distinct_
  double length_ = 0.0;               // of the last call
  Vec powers_, factors_;
};

}  // namespace fde
