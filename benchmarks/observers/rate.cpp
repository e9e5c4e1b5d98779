// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/rate.hpp"

#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fde::bench {
namespace {

constexpr double rounding = 1e-12;
constexpr std::size_t fewest_points = 3;

}  // namespace

Fit fit_rate(std::span<const ErrorSample> points) {
  double largest = 0.0;
  for (const auto& point : points) largest = std::max(largest, point.error);
  std::vector<double> x, y;
  for (const auto& [h, error] : points) {
    if (error <= rounding * std::max(largest, 1.0)) continue;
    x.push_back(std::log(h));
    y.push_back(std::log(error));
  }
  if (x.size() < fewest_points) return {};
  double intercept = 0, slope = 0, c00 = 0, c01 = 0, c11 = 0, residual = 0;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &intercept, &slope, &c00, &c01, &c11, &residual);
  return {.slope = slope,
          .correlation = gsl_stats_correlation(x.data(), 1, y.data(), 1, x.size()),
          .points = x.size()};
}

}  // namespace fde::bench
