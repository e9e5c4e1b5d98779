#pragma once

#include "weights/weights.hpp"

namespace fde {

// What the fractional integral of order g takes from one interval of a grid, where the integrand is linear:
//   1/Gamma(g) int_a^b (t - s)^(g-1) u(s) ds = left u(a) + right u(b),  t >= b.
// Good to a few units in the last place for every g in (0, 2], however short the interval is against its
// distance.
struct IntervalWeights {
  double left, right;
};

// distance = t - b >= 0, length = b - a > 0.
IntervalWeights interval_weights(double order, double distance, double length);

// The order of the integral that a rule of this table takes of its integrand: g for f, 1 - g for the slopes
// of y.
double integral_order(const WeightTable& table);

// The factor that turns integrals up to the end of a step of this length into weighted sums, in which the
// newest sample has weight 1: 1/step_factor where f is integrated, step_factor where slopes of y are.
double integrals_to_sums(const WeightTable& table, double length);

}  // namespace fde
