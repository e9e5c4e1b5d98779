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

// The end values of the linear function by which a rule of this family replaces its integrand between the
// samples before and after; for the newest interval of an implicit rule, `after` is 0.
struct Ends {
  double left, right;
};
Ends ends(WeightFamily family, double before, double after, double length);

// The order of the integral that a rule of this table takes of its integrand: g, and 1 - g for L1, which
// integrates the slopes of y.
double integral_order(const WeightTable& table);

// What turns integrals up to the end of a step of this length into weighted sums, in which the newest sample
// has weight 1: 1/step_factor for the rules that integrate f, step_factor for L1.
double integrals_to_sums(const WeightTable& table, double length);

}  // namespace fde
