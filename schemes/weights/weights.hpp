#pragma once

#include <cstdint>
#include <optional>

#include "problem/vectors.hpp"
#include "weights/family.hpp"

namespace fde {

// Weights of the past on equal steps, good to a few units in the last place at every lag and order in (0, 2].
// As usually printed they are differences of nearly equal powers and lose up to k^2 units; these are not.

// One weight table: a family and the order of the equation it serves. Order 0, that of an algebraic row, has
// no weights, and step_factor 1 for every length.
struct WeightTable {
  const WeightFamily* family;
  double order;
  bool operator==(const WeightTable&) const = default;
};

// w(lag) of a table, lag >= 1.
double weight(const WeightTable& table, std::int64_t lag);

// w(1), ..., w(count).
Vec first_weights(const WeightTable& table, Eigen::Index count);

// w(lag) - w(lag - 1), with 0 in place of w(0). The weights under it are extended, so it is off by their
// rounding, about 1/2000 unit of w(lag) as a double: small in every sum in which it stands for w.
double weight_increment(const WeightTable& table, std::int64_t lag);

// The value that w(k) has for every k, when there is one. Order 1 has no memory: a running sum replaces the
// history. Order 0 sums nothing: its value is 0.
std::optional<double> constant_weight(const WeightTable& table);

// Weight of x_0 at step n >= 1 where it is not w(n). nullopt: the rule is the plain convolution.
std::optional<double> start_weight(const WeightTable& table, std::int64_t n);

// kappa in y_n = past + kappa f(t_n, y_n) for a step of this length.
double step_factor(const WeightTable& table, double length);

}  // namespace fde
