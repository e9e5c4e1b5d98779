// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/mode_decay.hpp"

#include <cmath>
#include <complex>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

namespace fde::bench {

// Rounding perturbs z = rate t^g by a few units, and E_g(-z) by as many units of z E_g'(-z) = z E_{g,g}(-z) /
// g; the factor 2 covers the second-order terms.
DecayFactor decay_factor(double order, double rate, double t) {
  const double z = rate * std::pow(t, order), of_time = t > 0.0 ? std::abs(std::log(t)) : 0.0;
  const auto left = reference::mittag_leffler(order, 1.0, std::complex<double>(-z));
  const double slope = z * reference::mittag_leffler(order, order, -z) / order;
  return {left.value.real(), left.bound + 2.0 * (8.0 + of_time) * rounding_unit * std::abs(slope)};
}

double steepest_decay(double order, double least_rate, double t) {
  const double power = std::pow(t, order);
  if (order > 1.0) return power / (order * std::tgamma(order));
  return power * reference::mittag_leffler(order, order, -least_rate * power) / order;
}

}  // namespace fde::bench
