// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace fde::bench {

inline constexpr double rounding_unit = std::numeric_limits<double>::epsilon();

// The factor by which a mode has decayed, with an error bound.
struct DecayFactor {
  double value, bound;
};

// The solution at t of D^order u = -rate u, u(0) = 1, u'(0) = 0: E_order(-rate t^order), 0 < order <= 2.
DecayFactor decay_factor(double order, double rate, double t);

// A bound of |d decay / d rate| for all rates >= least_rate: the largest |t^g E_{g,g}(-rate t^g)| / g. Up to
// order 1, E_{g,g} decreases; above, |E_{g,g}| is below 1 / Gamma(g).
double steepest_decay(double order, double least_rate, double t);

}  // namespace fde::bench
