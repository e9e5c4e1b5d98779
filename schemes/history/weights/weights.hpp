// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fdebench/schemes/history/weights/family.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Weights of the memory term on equal steps, accurate to a few units in the last place at every lag and order
// in (0, 2]. The textbook formulas are differences of nearly equal powers and lose up to k^2 units.

// A family of weights for an equation of this order. Order 0 (an algebraic row) has no weights and the
// step_factor 1 for every length.
struct WeightTable {
  const WeightFamily* family;
  double order;
  bool operator==(const WeightTable&) const = default;
};

// w(lag) of a table, lag >= 1.
double weight(const WeightTable& table, std::int64_t lag);

// w(1), ..., w(count).
Vec first_weights(const WeightTable& table, Eigen::Index count);

// w(lag) - w(lag - 1), with 0 for w(0). It is computed from extended weights, so its absolute error is about
// 1/2000 unit in the last place of the double w(lag).
double weight_increment(const WeightTable& table, std::int64_t lag);

// The common value of all w(k); nullopt where they differ. It exists at order 1, where a running sum replaces
// the history, and is 0 at order 0, which has no memory term.
std::optional<double> constant_weight(const WeightTable& table);

// The weight of x_0 at step n >= 1; nullopt where it is w(n), as in a plain convolution.
std::optional<double> first_sample_weight(const WeightTable& table, std::int64_t n);

// kappa in y_n = memory + kappa f(t_n, y_n) for a step of this length.
double step_factor(const WeightTable& table, double length);

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
