// SPDX-License-Identifier: MIT
// The scene of Agrawal's extremum against its closed form and, with a spring, against a minimum by linear
// algebra.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "fdebench/benchmarks/observers/rate.hpp"
#include "support/two_sided_scenes.hpp"

namespace fde::bench {
namespace {

TEST(FractionalExtremum, IsExactWithoutASpring) {
  for (const double alpha : {0.501, 0.6, 0.75, 0.9, 0.999, 1.0}) {
    const auto scene = scene_of("fractional_extremum", {{"alpha", alpha}});
    for (const auto* id : both_schemes) EXPECT_LT(largest_error(scene, id, 256), 1e-12) << alpha << id;
  }
}

// y'' = k y.
TEST(FractionalExtremum, OfOrderOneIsAHyperbolicSine) {
  const double k = 4.0;
  auto scene = scene_of("fractional_extremum", {{"alpha", 1.0}, {"k", k}});
  scene.reference = {[=](double t) -> reference::ReferenceValue {
    return {Vec::Constant(1, std::sinh(2.0 * t) / std::sinh(2.0)), Vec::Zero(1)};
  }};
  std::vector<ErrorSample> errors;
  for (int steps = 64; steps <= 1024; steps *= 2)
    errors.push_back({1.0 / steps, largest_error(scene, "product_trapezoidal", steps)});
  EXPECT_NEAR(fit_rate(errors).slope, 2.0, 0.1);
}

// The y, at the times, that minimises 1/2 int p^2 + k y^2 over all p that are constant on cells graded
// towards the end, y = J^alpha p, y(1) = 1; int y^2 by the two-point Gauss rule.
Vec dense_minimum(double alpha, double k, int cells, const std::vector<double>& times) {
  const Vec places = Vec::NullaryExpr(
      cells + 1, [&](Eigen::Index j) { return 1.0 - std::pow(1.0 - static_cast<double>(j) / cells, 4.0); });
  const auto weights = [&](double t) -> Vec {
    return Vec::NullaryExpr(cells, [&](Eigen::Index j) {
      const auto power_since = [&](double from) { return std::pow(std::max(t - from, 0.0), alpha); };
      return (power_since(places[j]) - power_since(places[j + 1])) / std::tgamma(alpha + 1.0);
    });
  };
  Matrix form = (places.tail(cells) - places.head(cells)).asDiagonal();
  Matrix points(cells, 2 * cells);
  for (Eigen::Index j = 0; j < cells; ++j) {
    const double length = form(j, j), middle = places[j] + length / 2, off = length / (2 * std::sqrt(3.0));
    points.col(2 * j) = std::sqrt(k * length / 2) * weights(middle - off);
    points.col(2 * j + 1) = std::sqrt(k * length / 2) * weights(middle + off);
  }
  form.noalias() += points * points.transpose();
  const Vec at_end = weights(1.0), p = form.llt().solve(at_end);
  return Vec::NullaryExpr(std::ssize(times), [&](Eigen::Index i) {
    return weights(times[static_cast<std::size_t>(i)]).dot(p) / at_end.dot(p);
  });
}

TEST(FractionalExtremum, WithASpringIsTheDenseMinimum) {
  for (const auto& of : {std::pair{0.75, 5.0}, {0.9, 20.0}}) {
    const double alpha = of.first, k = of.second;
    const auto scene = scene_of("fractional_extremum", {{"alpha", alpha}, {"k", k}});
    const auto path = solve("product_trapezoidal", scene.problem, 4096, {.output_times = {0.25, 0.5, 0.75}});
    const Vec y = columns_of(scene.outputs, path).row(0).transpose();
    const auto off = [&](int cells) {
      return (dense_minimum(alpha, k, cells, {0.25, 0.5, 0.75}) - y).cwiseAbs().maxCoeff();
    };
    const double coarse = off(100), fine = off(400);
    EXPECT_LT(fine, 1e-5);
    EXPECT_LT(fine, coarse / 3.0);
    // Without the spring y is far from these values.
    const Scene free = scene_of("fractional_extremum", {{"alpha", alpha}});
    EXPECT_GT(std::abs(free.reference.at(0.5).value[0] - y[1]), 0.1);
  }
}

// y starts like t^alpha and ends like (1 - t)^(2 alpha - 1): both contribute an error h^(2 alpha). The next
// power of h, h^(4 alpha - 1), is so close that it is eliminated: d(h) - 2^q d(h/2) has no h^q.
TEST(FractionalExtremum, WithASpringShowsTheRateOfItsEnds) {
  for (const double alpha : {0.6, 0.7}) {
    const auto scene = scene_of("fractional_extremum", {{"alpha", alpha}, {"k", 10.0}});
    std::vector<double> middle, differences;
    for (int steps = 256; steps <= 8192; steps *= 2) {
      const auto path = solve("product_trapezoidal", scene.problem, steps, {.output_times = {0.5}});
      middle.push_back(columns_of(scene.outputs, path)(0, 0));
      if (middle.size() > 1) differences.push_back(middle.end()[-2] - middle.end()[-1]);
    }
    std::vector<ErrorSample> first_power;
    for (std::size_t i = 0; i + 1 < differences.size(); ++i) {
      const double rest = differences[i] - std::pow(2.0, 4.0 * alpha - 1.0) * differences[i + 1];
      first_power.push_back({std::pow(2.0, -static_cast<double>(i)), std::abs(rest)});
    }
    const double expected =
        find_scheme("product_trapezoidal")->expected_rate(scene.problem, scene.smoothness, 1.0, Norm::end);
    EXPECT_NEAR(expected, 2.0 * alpha, 1e-12);
    EXPECT_NEAR(fit_rate(first_power).slope, expected, 0.05) << alpha;
  }
}

}  // namespace
}  // namespace fde::bench
