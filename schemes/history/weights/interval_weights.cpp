// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/interval_weights.hpp"

#include <cmath>

namespace fde {
namespace {

// int_0^1 (1-v) (1 - x v)^(g-1) dv and int_0^1 v (1 - x v)^(g-1) dv by their series in x <= 1/2, whose terms
// are positive for g <= 1.
IntervalWeights by_series(double g, double x) {
  double power = 1.0, left = 0.5, right = 0.5;
  for (int k = 1; std::abs(power) > 1e-17 * right; ++k) {
    power *= x * (k - g) / k;
    left += power / ((k + 1.0) * (k + 2.0));
    right += power / (k + 2.0);
  }
  return {left, right};
}

// The same in closed form, for x in (1/2, 1]; rest = 1 - x, given without cancellation.
IntervalWeights by_powers(double g, double x, double rest) {
  const double constant = -std::expm1(g * std::log(rest)) / (g * x);
  const double next = -std::expm1((g + 1.0) * std::log(rest)) / ((g + 1.0) * x);
  return {(next - rest * constant) / x, (constant - next) / x};
}

}  // namespace

IntervalWeights interval_weights(double order, double distance, double length) {
  const double far = distance + length, x = length / far;
  const double scale = x * std::pow(far, order) / std::tgamma(order);
  const auto [left, right] = x <= 0.5 ? by_series(order, x) : by_powers(order, x, distance / far);
  return {scale * left, scale * right};
}

double integral_order(const WeightTable& table) {
  return table.family->acts_on_increments ? 1.0 - table.order : table.order;
}

double integral_to_sum_factor(const WeightTable& table, double length) {
  const double kappa = step_factor(table, length);
  return table.family->acts_on_increments ? kappa : 1.0 / kappa;
}

}  // namespace fde
