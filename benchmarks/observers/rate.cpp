// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/rate.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace fde::bench {
namespace {

constexpr std::size_t fewest_points = 3;

Eigen::VectorXd from_mean(const std::vector<double>& values) {
  const Eigen::Map<const Eigen::ArrayXd> array(values.data(), std::ssize(values));
  return array - array.mean();
}

}  // namespace

Fit fit_rate(std::span<const ErrorSample> points) {
  constexpr double rounding = 1e-12;
  double largest = 0.0;
  for (const auto& point : points) largest = std::max(largest, point.error);
  std::vector<double> x, y;
  for (const auto& [h, error] : points) {
    if (error <= rounding * std::max(largest, 1.0)) continue;
    x.push_back(std::log(h));
    y.push_back(std::log(error));
  }
  if (x.size() < fewest_points) return {};
  const Eigen::VectorXd dx = from_mean(x), dy = from_mean(y);
  return {.slope = dx.dot(dy) / dx.squaredNorm(),
          .correlation = dx.dot(dy) / (dx.norm() * dy.norm()),
          .points = x.size()};
}

}  // namespace fde::bench
