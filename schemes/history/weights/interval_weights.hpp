// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/weights/weights.hpp"

namespace fde {

// The weights of one interval in a fractional integral of order g with a linear integrand u:
//   1/Gamma(g) int_a^b (t - s)^(g-1) u(s) ds = left u(a) + right u(b),  t >= b.
// Accurate to a few units in the last place for every g in (0, 2], also for intervals that are short compared
// to t - b.
struct IntervalWeights {
  double left, right;
};

// The weights for order g. Preconditions: distance = t - b >= 0, length = b - a > 0.
IntervalWeights interval_weights(double order, double distance, double length);

// The order with which a rule of this table integrates: g where it integrates f, 1 - g for the slope of y.
double integral_order(const WeightTable& table);

// The factor from the integral up to the end of a step of this length to the memory sum, in which the newest
// sample has weight 1: 1/step_factor where f is integrated, step_factor where the slope of y is.
double integral_to_sum_factor(const WeightTable& table, double length);

}  // namespace fde
