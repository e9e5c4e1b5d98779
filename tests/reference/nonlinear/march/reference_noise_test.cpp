// SPDX-License-Identifier: MIT
// References for right-hand sides that consist of rounding errors, entirely or in part.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reference/nonlinear/collocation.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"
#include "support/testing.hpp"

namespace fde::reference {
namespace {

constexpr double double_epsilon = std::numeric_limits<double>::epsilon();

// D^order x = factor (sin^2 z + cos^2 z - 1), z' = 1: x = 0 and z = t.
Problem cancelling(double order, double factor) {
  return {.components = {{order, order > 1.0 ? std::vector{0.0, 0.0} : std::vector{0.0}}, {1.0, {0.0}}},
          .rhs =
              [factor](double, In y, Out f) {
                const double sine = std::sin(y[1]), cosine = std::cos(y[1]);
                f << factor * (sine * sine + cosine * cosine - 1.0), 1.0;
              },
          .end = 5.0};
}

TEST(RhsNoise, IsNoneWhereFIsSmooth) {
  const Problem problem{.components = {{0.5, {1.0}}},
                        .rhs = [](double t, In y, Out f) { f[0] = t * t + std::exp(y[0]); }};
  EXPECT_LT(rhs_noise(problem, 0.5, Vec::Constant(1, 1.0), 0.6, Vec::Constant(1, 1.1))[0],
            3 * double_epsilon);
}

TEST(RhsNoise, IsThatOfTermsThatCancel) {
  for (const double factor : {1.0, 1e-6}) {
    const Vec noise = rhs_noise(cancelling(0.5, factor), 1.0, Vec{{0.0, 1.0}}, 1.1, Vec{{0.0, 1.1}});
    EXPECT_GT(noise[0], 0.1 * double_epsilon * factor);
    EXPECT_LT(noise[0], 2 * double_epsilon * factor);
    EXPECT_EQ(noise[1], 0.0);
  }
}

TEST(RhsNoise, IsZeroWhereFIsNotFinite) {
  const Problem problem{.components = {{0.5, {1.0}}},
                        .rhs = [](double, In y, Out f) { f[0] = std::sqrt(y[0]); }};
  EXPECT_EQ(rhs_noise(problem, 0.0, Vec::Constant(1, 1.0), 1.0, Vec::Constant(1, -1.0))[0], 0.0);
}

class Cancelling : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(Cancelling, TermsLeaveNothingWithinASmallBound) {
  const auto [order, factor] = GetParam();
  const Reference reference = reference_solution(cancelling(order, factor));
  for (const double t : {1e-12, 1e-7, 1e-3, 1.0, 5.0}) {
    const ReferenceValue known = reference.at(t);
    EXPECT_NEAR(known.value[0], 0.0, known.bound[0]) << t;
    EXPECT_NEAR(known.value[1], t, known.bound[1]) << t;
    EXPECT_LT(known.bound[0], 2e-14 * factor) << t;
    EXPECT_LT(known.bound[1], 1e-13) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(, Cancelling,
                         testing::Values(std::pair{0.5, 1.0}, std::pair{0.1, 1.0}, std::pair{1.0, 1.0},
                                         std::pair{1.6, 1.0}, std::pair{0.5, 1e-6}, std::pair{0.5, 50.0}));

// x, which is rounding noise, enters y'' = x - y, y = cos t.
TEST(ReferenceOfNoise, PassesItOnWithinTheBound) {
  Problem problem = cancelling(0.5, 1.0);
  problem.components.push_back({2.0, {1.0, 0.0}});
  problem.rhs = [inner = problem.rhs](double t, In y, Out f) {
    inner(t, y, f.head(2));
    f[2] = y[0] - y[2];
  };
  const Reference reference = reference_solution(problem);
  for (const double t : {0.1, 1.0, 5.0}) {
    const ReferenceValue known = reference.at(t);
    EXPECT_NEAR(known.value[2], std::cos(t), known.bound[2]) << t;
    EXPECT_LT(known.bound[2], 1e-13) << t;
  }
}

class SphericalKnifeEdge : public testing::TestWithParam<bench::ParameterValues> {};

// Without gravity, and without memory (b = 0) or with the derivative of order 1 (alpha = 1), theta' and
// phi' sin theta / k are the same constant: phi = k log(tan(theta / 2) / tan(theta(0) / 2)).
TEST_P(SphericalKnifeEdge, WithoutGravityIsALoxodrome) {
  auto values = GetParam();
  values.insert({{"surface", "sphere"}, {"g", 0.0}});
  const Reference reference = reference_of(bench::scene_of("fractional_knife_edge", values));
  for (const double t : {1e-6, 0.5, 1.0, 2.0}) {
    const ReferenceValue known = reference.at(t);
    const double down = 0.5 / std::hypot(1.0, 0.5), theta = 0.7 + down * t;
    const double phi = 0.5 * std::log(std::tan(theta / 2) / std::tan(0.35));
    EXPECT_NEAR(known.value[0], theta, known.bound[0] + double_epsilon) << t;
    EXPECT_NEAR(known.value[1], phi, known.bound[1] + 4 * double_epsilon) << t;
    EXPECT_LT(known.bound.head(2).maxCoeff(), 2e-14) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(, SphericalKnifeEdge,
                         testing::ValuesIn<bench::ParameterValues>(
                             {{{"b", 0.0}}, {{"b", 0.0}, {"alpha", 0.3}}, {{"alpha", 1.0}}}));

// The speed is not conserved, but a reference exists.
TEST(ReferenceOfNoise, TakesMemoryOnASphereWithoutGravity) {
  const Reference reference =
      reference_of(bench::scene_of("fractional_knife_edge", {{"surface", "sphere"}, {"g", 0.0}}));
  EXPECT_LT(reference.at(1.0).bound.maxCoeff(), 2e-14);
}

// A jump of f does not count as noise: there is no reference, and the solver fails within 20 seconds.
TEST(ReferenceOfNoise, TakesNoJumpForRounding) {
  const auto start = std::chrono::steady_clock::now();
  const Problem problem{.components = {{0.5, {0.0}}},
                        .rhs = [](double t, In, Out f) { f[0] = std::floor(std::sin(1e9 * t) + 1.0); }};
  bench::expect_message([&] { reference_solution(problem); }, "t = ");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

}  // namespace
}  // namespace fde::reference
