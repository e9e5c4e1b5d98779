// SPDX-License-Identifier: MIT
// Extrapolation of a path by the polynomial through its newest points.

#include "fdebench/schemes/rules/implicit/extrapolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fde::bench {
namespace {

constexpr int most_points = 7;

Vec powers(double t, int degree) {
  return Vec::NullaryExpr(degree + 1, [=](Eigen::Index k) { return std::pow(t, static_cast<double>(k)); });
}

// The error of the extrapolation to the time after the last one, with the number of points that is best
// there.
double largest_error(const std::vector<double>& times, int degree) {
  Extrapolation extrapolation(degree + 1);
  for (std::size_t i = 0; i + 2 < times.size(); ++i) extrapolation.push(times[i], powers(times[i], degree));
  const Vec newest = powers(times[times.size() - 2], degree);
  extrapolation.choose_count(times[times.size() - 2], newest, Vec::Ones(degree + 1));
  extrapolation.push(times[times.size() - 2], newest);
  Vec value(degree + 1);
  extrapolation.at(times.back(), value);
  return (value - powers(times.back(), degree)).lpNorm<Eigen::Infinity>();
}

// n points determine polynomials of degree n - 1. The weights for points at equal distances are those for any
// points.
TEST(Extrapolation, IsExactForPolynomials) {
  for (int degree = 0; degree < most_points; ++degree) {
    std::vector<double> equal, growing;
    for (int i = 0; i < 20; ++i) equal.push_back(1.0 + 0.05 * i);
    for (int i = 0; i < 12; ++i) growing.push_back(0.5 * std::pow(1.1, i));
    EXPECT_LT(largest_error(equal, degree), 1e-12) << degree;
    EXPECT_LT(largest_error(growing, degree), 1e-12) << degree;
  }
  std::vector<double> equal;
  for (int i = 0; i < 20; ++i) equal.push_back(1.0 + 0.05 * i);
  EXPECT_GT(largest_error(equal, most_points), 1e-8);
}

// Steps of other lengths: the weights for equal distances would be wrong by a factor.
TEST(Extrapolation, FollowsAChangeOfTheDistance) {
  std::vector<double> times;
  for (int i = 0; i < 10; ++i) times.push_back(0.1 * i);
  for (int i = 0; i < 9; ++i) {
    times.push_back(times.back() + 0.03);
    EXPECT_LT(largest_error(times, most_points - 1), 1e-11) << i;
  }
}

// The rounding errors of independent points grow by the root of the sum of the squared weights, 1 for one
// point and 58.6 for seven; a smooth path in long steps needs many points.
TEST(Extrapolation, ChoosesFewPointsForNoiseAndManyForLongSteps) {
  constexpr double noise = 1e-6, step = 0.2;
  const auto error_of = [](const auto& path, double length) {
    Extrapolation extrapolation(1);
    std::vector<double> errors;
    for (int n = 0; n < 200; ++n) {
      const double t = length * n;
      const Vec exact = Vec::Constant(1, path(n, t));
      Vec value(1);
      if (n > 20) {
        extrapolation.at(t, value);
        errors.push_back(value[0] - exact[0]);
        extrapolation.choose_count(t, exact, Vec::Ones(1));
      }
      extrapolation.push(t, exact);
    }
    double sum = 0.0;
    for (const double error : errors) sum += error * error;
    return std::sqrt(sum / static_cast<double>(errors.size()));
  };
  std::mt19937 numbers(1);
  std::normal_distribution<double> normal(0.0, noise);
  EXPECT_LT(error_of([&](int, double) { return 1.0 + normal(numbers); }, step), 15 * noise);
  EXPECT_LT(error_of([](int, double t) { return std::sin(t); }, step), 2 * std::pow(step, most_points));
}

}  // namespace
}  // namespace fde::bench
