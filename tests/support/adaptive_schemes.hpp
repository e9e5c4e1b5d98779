// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/reference/reference.hpp"
#include "support/testing.hpp"

namespace fde::bench {

// The schemes with an adaptive step size.
inline std::vector<const Scheme*> adaptive_schemes() {
  auto some = all_schemes();
  std::erase_if(some, [](const Scheme* scheme) { return !scheme->capabilities.is_adaptive(); });
  return some;
}

// A scheme and a scene; prints as its scheme and label.
struct AccuracyRun {
  std::string scheme, scene;
  ParameterValues values{};
};
// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
inline void PrintTo(const AccuracyRun& asked, std::ostream* out) {
  *out << asked.scheme << ' ' << SceneVariant{&scene_factory(asked.scene), asked.values}.label();
}
inline constexpr auto name_of_run = [](const auto& test) {
  return as_identifier(testing::PrintToString(test.param));
};

// The largest error relative to 1 + |y|, beyond so many bounds of the reference, at about 64 of the run's own
// times.
inline double largest_error(const Scene& scene, const reference::Reference& reference, const Trajectory& path,
                            double bounds = 1.0) {
  double largest = 0.0;
  for (Eigen::Index i = 1; i < path.y.cols(); i += 1 + path.y.cols() / 64) {
    const auto exact = reference.at(path.time(i));
    const Vec columns = columns_at(scene.outputs, path.time(i), path.y.col(i));
    const Vec error = (columns - exact.value).cwiseAbs() - bounds * exact.bound;
    const double worst =
        error.cwiseQuotient(Vec(1.0 + exact.value.array().abs())).maxCoeff<Eigen::PropagateNaN>();
    if (std::isnan(worst)) return worst;
    largest = std::max(largest, worst);
  }
  return largest;
}

// Expects that a row is this function of time, at about `most` of the times of the run.
inline void expect_row(const Trajectory& path, Eigen::Index row, const std::function<double(double)>& exact,
                       double tolerance, Eigen::Index most = 1'000'000) {
  for (Eigen::Index c = 0; c < path.y.cols(); c += 1 + path.y.cols() / most)
    EXPECT_NEAR(path.y(row, c), exact(path.time(c)), tolerance) << "t = " << path.time(c);
}

// D^0.5 y = 1 up to t = 1 and -1 after it: y = (2 sqrt t - 4 sqrt(t - 1)) / sqrt pi.
inline Problem jumping_problem(std::vector<double> jump_times) {
  return {.components = {{0.5, {0.0}}},
          .rhs = [](double t, In, Out f) { f[0] = t <= 1.0 ? 1.0 : -1.0; },
          .end = 3.0,
          .jump_times = std::move(jump_times)};
}
inline double solution_of_jumping_problem(double t) {
  return (2.0 * std::sqrt(t) - 4.0 * std::sqrt(std::max(0.0, t - 1.0))) * std::numbers::inv_sqrtpi;
}

// D^0.5 y = 1, and 2 where y > 1: y = (2 sqrt t + 2 sqrt(t - pi/4)) / sqrt pi, as 1 is reached at pi/4.
inline Problem switching_problem() {
  return {.components = {{0.5, {0.0}}},
          .rhs = [](double, In y, Out f) { f[0] = y[0] > 1.0 ? 2.0 : 1.0; },
          .end = 2.0,
          .switching_functions = {[](double, In y) { return y[0] - 1.0; }}};
}
inline double solution_of_switching_problem(double t) {
  return 2.0 * (std::sqrt(t) + std::sqrt(std::max(0.0, t - std::numbers::pi / 4.0))) *
         std::numbers::inv_sqrtpi;
}

// D^order y = y^2, y(0) = 1; for order 1, y = 1 / (1 - t).
inline Problem blow_up_problem(double order) {
  return {.components = {{order, {1.0}}}, .rhs = [](double, In y, Out f) { f = y.cwiseAbs2(); }, .end = 2.0};
}

}  // namespace fde::bench
