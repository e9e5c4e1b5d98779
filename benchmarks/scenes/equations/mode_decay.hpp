#pragma once

#include <limits>

namespace fde {

inline constexpr double rounding_unit = std::numeric_limits<double>::epsilon();

// What is left of a mode, and a bound of the error of that.
struct Decay {
  double value, bound;
};

// The solution at t of D^order u = -rate u from 1, without velocity: E_order(-rate t^order), 0 < order <= 2.
Decay decay(double order, double rate, double t);

// The most that it changes with the rate, per unit of it, for rates from this one on: the largest
// |t^g E_{g,g}(-rate t^g)| / g. Up to order 1, E_{g,g} decreases; above, |E_{g,g}| is below 1 / Gamma(g).
double steepest_decay(double order, double least_rate, double t);

}  // namespace fde
