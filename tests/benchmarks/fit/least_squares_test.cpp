// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/fit/least_squares.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace fde::bench {
namespace {

const LeastSquaresOptions precise{.tolerance = 1e-12, .difference = 1e-4};

// Misra1a of NIST's Statistical Reference Datasets, y = b1 (1 - exp(-b2 x)), from its far start.
TEST(LeastSquaresFits, HaveTheCertifiedValuesOfNist) {
  constexpr std::array x{77.6,  114.9, 141.1, 190.8, 239.9, 289.0, 332.8,
                         378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0};
  constexpr std::array y{10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02,
                         44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78};
  const auto residuals = [&](const Vec& b) -> std::optional<Vec> {
    Vec r(std::ssize(x));
    for (std::size_t i = 0; i < x.size(); ++i)
      r[static_cast<Eigen::Index>(i)] = b[0] * -std::expm1(-1e-4 * b[1] * x[i]) - y[i];
    return r;
  };
  const auto found = least_squares(residuals, Vec{{500.0, 1.0}}, precise);
  ASSERT_TRUE(found.has_converged);
  EXPECT_NEAR(found.z[0], 2.3894212918e2, 1e-6);
  EXPECT_NEAR(found.z[1], 5.5015643181, 1e-8);
  const double variance = found.residuals.squaredNorm() / 12.0;
  const Matrix covariance = variance * (found.jacobian.transpose() * found.jacobian).inverse();
  EXPECT_NEAR(std::sqrt(variance), 1.0187876330e-1, 1e-9);
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), 2.7070075241, 1e-6);
  EXPECT_NEAR(std::sqrt(covariance(1, 1)), 7.2668688436e-2, 1e-8);
}

// Rosenbrock's valley: the minimum, 0, is at (1, 1).
std::optional<Vec> rosenbrock(const Vec& z) { return Vec{{10.0 * (z[1] - z[0] * z[0]), 1.0 - z[0]}}; }

TEST(LeastSquaresFits, FollowACurvedValley) {
  const auto found = least_squares(rosenbrock, Vec{{-1.2, 1.0}}, precise);
  EXPECT_TRUE(found.has_converged);
  EXPECT_NEAR(found.z[0], 1.0, 1e-9);
  EXPECT_NEAR(found.z[1], 1.0, 1e-9);
}

// Steps are bounded by the size of the variables' changes: 0 is a start as any other, also of a large
// residual.
TEST(LeastSquaresFits, StartAtZeroToo) {
  const auto residuals = [](const Vec& z) -> std::optional<Vec> {
    return Vec{{1e4 * (std::tanh(z[0]) - 0.7), 1e4 * (z[0] - z[1])}};
  };
  for (const double start : {0.0, 1e-12, -0.1}) {
    const auto found = least_squares(residuals, Vec{{start, start}}, precise);
    EXPECT_TRUE(found.has_converged) << start;
    EXPECT_NEAR(found.z[1], std::atanh(0.7), 1e-9) << start;
    EXPECT_LT(found.iterations, 10) << start;
  }
}

// The model has no values next to the minimum, where long steps lead.
TEST(LeastSquaresFits, RejectTrialsWithoutResiduals) {
  int rejected = 0;
  const auto residuals = [&](const Vec& z) -> std::optional<Vec> {
    if (z[0] > 1.001 || z[1] < 0.0) {
      ++rejected;
      return std::nullopt;
    }
    return rosenbrock(z);
  };
  const auto found = least_squares(residuals, Vec{{-1.0, 0.5}}, precise);
  EXPECT_TRUE(found.has_converged);
  EXPECT_NEAR(found.z[0], 1.0, 1e-9);
  EXPECT_GT(rejected, 0);
}

// No trial is farther from the last accepted point than a tenth.
TEST(LeastSquaresFits, StayWithinReach) {
  auto options = precise;
  options.reach = [](Eigen::Index, double) { return 0.1; };
  Vec last{{-1.2, 1.0}};
  int far = 0;
  const auto found = least_squares(
      [&](const Vec& z) {
        if ((z - last).cwiseAbs().maxCoeff() > 0.1 + 1e-3) ++far;
        if (rosenbrock(z)->norm() < rosenbrock(last)->norm()) last = z;
        return rosenbrock(z);
      },
      last, options);
  EXPECT_EQ(far, 0);
  EXPECT_NEAR(found.z[0], 1.0, 1e-9);
}

TEST(LeastSquaresFits, HaveConvergedWhereNothingIsLeft) {
  const auto found = least_squares([](const Vec& z) { return std::optional(Vec(z * 0.0)); }, Vec{{2.0}}, {});
  EXPECT_TRUE(found.has_converged);
  EXPECT_EQ(found.z[0], 2.0);
}

}  // namespace
}  // namespace fde::bench
