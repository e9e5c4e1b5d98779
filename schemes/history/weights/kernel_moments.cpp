// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/kernel_moments.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

namespace {

// The rate of decay in m_l ~ e^(-l decay) for z > 1 (Bernstein's ellipse through z); 0 for z <= 1.
double decay(double beyond) {
  return beyond <= 0.0 ? 0.0 : std::log1p(beyond + std::sqrt(beyond * (2.0 + beyond)));
}

// ((z+1)^order - max(z-1, 0)^order) / order.
double zeroth(double order, double beyond) {
  if (beyond < 1.0) return (std::pow(2.0 + beyond, order) - std::pow(std::max(beyond, 0.0), order)) / order;
  return std::pow(beyond, order) * std::expm1(order * std::log1p(2.0 / beyond)) / order;
}

// Forward recurrence from m_0 and m_1, for z where all solutions are of similar size. zeroth is Gamma(order)
// m_0 and zeroth_of_next the same for order + 1.
void upwards(double order, double z, double zeroth, double zeroth_of_next, Out m) {
  const double a = order - 1.0;
  m[0] = zeroth;
  if (m.size() > 1) m[1] = z * zeroth - zeroth_of_next;
  for (Eigen::Index i = 1; i + 1 < m.size(); ++i) {
    const auto l = static_cast<double>(i);
    m[i + 1] = ((2.0 * l + 1.0) * z * m[i] - (l - 1.0 - a) * m[i - 1]) / (l + 2.0 + a);
  }
}

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

Matrix kernel_moments(double order, const Vec& beyond, Eigen::Index count) {
  const double equal = 0.75 / static_cast<double>(count);  // up to this decay the recurrence loses one digit
  constexpr double digits =
      20.0;  // half of the digits, as a power of e: the error of the first ratio decays quadratically
  const double a = order - 1.0;
  Matrix moments(count, beyond.size());  // one column a point
  Eigen::Array<bool, Eigen::Dynamic, 1> falls(beyond.size());
  double slowest = 100.0;
  for (Eigen::Index j = 0; j < beyond.size(); ++j) {
    const double fall = decay(beyond[j]);
    falls[j] = fall > equal;
    if (falls[j]) slowest = std::min(slowest, fall);
    if (falls[j]) continue;
    upwards(order, 1.0 + beyond[j], zeroth(order, beyond[j]), zeroth(order + 1.0, beyond[j]), moments.col(j));
  }
  if (falls.any()) {
    // Backward recurrence for the ratios m_l / m_(l-1) (Miller), at all points at once.
    const Eigen::ArrayXd z = 1.0 + beyond.array();
    Eigen::ArrayXd ratio = Eigen::ArrayXd::Zero(z.size());
    Matrix ratios(z.size(), count);
    for (auto i = count + static_cast<Eigen::Index>(digits / slowest); i >= 1; --i) {
      const auto l = static_cast<double>(i);
      ratio = (l - 1.0 - a) / ((2.0 * l + 1.0) * z - (l + 2.0 + a) * ratio);
      if (i < count) ratios.col(i) = ratio;
    }
    for (Eigen::Index j = 0; j < z.size(); ++j) {
      if (!falls[j]) continue;
      moments(0, j) = zeroth(order, beyond[j]);
      for (Eigen::Index l = 1; l < count; ++l) moments(l, j) = moments(l - 1, j) * ratios(j, l);
    }
  }
  return moments.transpose() / std::tgamma(order);
}

Vec moments_inside_panel(double order, double since, Eigen::Index count) {
  Vec moments(count);
  const double power = std::pow(since, order);
  upwards(order, since - 1.0, power / order, power * since / (order + 1.0), moments);
  return moments / std::tgamma(order);
}

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
