// SPDX-License-Identifier: MIT
// Linear systems with rows of order 0: motions under the fractional constraint f = a.v + b.D^alpha q = C0
// (Tarasov & Zaslavsky 2006, eq. 42 and 55-66), compared with formulations without a multiplier.

#include <fmt/format.h>

#include "benchmarks/mechanics/constrained_motion_testing.hpp"

namespace fde::bench {
namespace {

constexpr auto name_of = [](const auto& test) { return std::string(test.param.name); };

class BelowOne : public testing::TestWithParam<Motion> {};

// z = v + A w with A = a b^T / |a|^2 satisfies z' = -P grad u, P = I - a a^T / |a|^2: the multiplier is
// eliminated.
TEST_P(BelowOne, IsTheIntegratedForm) {
  const auto precision = test_precision();
  const Motion& m = GetParam();
  const reference::Reference multiplier = reference::linear_reference(
                                 with_multiplier(m, OutputChoice::positions_and_memory)),
                             integrated = reference::linear_reference(integrated_form(m));
  for (const double t : {0.03125, 1.0, 7.0}) {
    const auto values = digits_at(multiplier, t), exact = digits_at(integrated, t);
    const reference::ReferenceValue in_double = multiplier.at(t), other = integrated.at(t);
    for (std::size_t i = 0; i < 2; ++i) {
      expect_equal(values[i], exact[i], fmt::format("q{} at {}", i, t), reference::BigReal(1));
      expect_equal(values[2 + i], exact[4 + i], fmt::format("w{} at {}", i, t), reference::BigReal(1));
      const auto k = static_cast<Eigen::Index>(i);
      EXPECT_NEAR(in_double.value[k], other.value[k], 1e-14);
      EXPECT_NEAR(in_double.value[2 + k], other.value[4 + k], 1e-14);
    }
  }
}

TEST_P(BelowOne, KeepsTheConstraint) {
  const auto precision = test_precision();
  const Motion& m = GetParam();
  const reference::Reference solution =
      reference::linear_reference(with_multiplier(m, OutputChoice::velocities_and_memory));
  reference::BigReal start(0);
  for (std::size_t i = 0; i < 2; ++i) {
    start += reference::from_shortest_decimal<reference::BigReal>(m.a[i]) *
             reference::from_shortest_decimal<reference::BigReal>(m.v0[i]);
  }
  for (const double t : {1e-6, 0.5, 20.0}) {
    const auto y = digits_at(solution, t);
    reference::BigReal f(0);
    for (std::size_t i = 0; i < 2; ++i) {
      f += reference::from_shortest_decimal<reference::BigReal>(m.a[i]) * y[i] +
           reference::from_shortest_decimal<reference::BigReal>(m.b[i]) * y[2 + i];
    }
    expect_equal(f, start, fmt::format("f at {}", t), reference::BigReal(1));
  }
}

INSTANTIATE_TEST_SUITE_P(AlgebraicLinearSystem, BelowOne,
                         testing::Values(Motion{.name = "Slow", .alpha = 0.05, .rest = 0.95},
                                         Motion{.name = "Half"},
                                         Motion{.name = "Fast", .alpha = 0.95, .rest = 0.05},
                                         Motion{.name = "Moving", .v0 = {3.0, 0.25}},
                                         Motion{.name = "NoMemory", .b = {0.0, 0.0}}),
                         name_of);

// 1 < alpha < 2, c (v1 + v2) + b2 D^alpha q2 = 0, u = (q1^2 - q2^2)/4: x = (q1 + q2)/2 satisfies
//   x'' + x/2 + (2/g) D^(3-alpha) x = 0,  g = b2/c    (Tarasov & Zaslavsky's eq. 66, corrected).
struct Oscillator {
  const char* name;
  double alpha, above, below, damping_order;  // alpha - 1, 2 - alpha, 3 - alpha
};

class FractionalOscillator : public testing::TestWithParam<Oscillator> {};

TEST_P(FractionalOscillator, IsTheMeanOfTheCoordinates) {
  const auto precision = test_precision();
  const auto& [name, alpha, above, below, damping_order] = GetParam();
  const reference::Reference system =
      reference::linear_reference(with_multiplier_above_one({.alpha = alpha,
                                                             .k = {0.5, -0.5},
                                                             .g = {0.0, 0.0},
                                                             .a = {2.0, 2.0},
                                                             .b = {0.0, 1.6},
                                                             .q0 = {1.2, -0.4},
                                                             .v0 = {0.3, -0.3}},
                                                            above, below));
  const reference::Reference oscillator = reference::linear_reference(
      {.terms = {{1.0, 2.0}, {2.5, damping_order}, {0.5, 0.0}}, .initial = {0.4, 0.0}}, {0.0, 1.0});
  for (const double t : {0.125, 2.0, 9.0}) {
    const auto q = digits_at(system, t), x = digits_at(oscillator, t);
    expect_equal(reference::BigReal((q[0] + q[1]) / 2), x[0], fmt::format("x at {}", t),
                 reference::BigReal(1));
    expect_equal(reference::BigReal((q[2] + q[3]) / 2), x[1], fmt::format("x' at {}", t),
                 reference::BigReal(1));
  }
}

INSTANTIATE_TEST_SUITE_P(AlgebraicLinearSystem, FractionalOscillator,
                         testing::Values(Oscillator{"Weak", 1.1, 0.1, 0.9, 1.9},
                                         Oscillator{"Middle", 1.5, 0.5, 0.5, 1.5},
                                         Oscillator{"Strong", 1.95, 0.95, 0.05, 1.05}),
                         name_of);

// a1 = 0: the first coordinate is free, and a2 v2 + b1 D^alpha q1 + b2 D^alpha q2 = a2 v2(0) determines the
// second (eq. 57; 58 for b2 = 0).
TEST(AlgebraicLinearSystem, FollowsAFreeCoordinate) {
  const auto precision = test_precision();
  const Motion m{
      .alpha = 0.3, .rest = 0.7, .k = {4.0, 1.0}, .g = {0.0, 2.0}, .a = {0.0, 2.0}, .b = {0.5, 0.0}};
  const reference::Reference solution = reference::linear_reference(
                                 with_multiplier(m, OutputChoice::velocities_and_memory)),
                             free = reference::linear_reference(
                                 {.terms = {{1.0, 2.0}, {4.0, 0.0}}, .initial = {m.q0[0], m.v0[0]}},
                                 {1.0, m.alpha});
  for (const double t : {0.25, 3.0}) {
    const auto y = digits_at(solution, t), x = digits_at(free, t);
    expect_equal(y[0], x[0], "v1", reference::BigReal(1));
    expect_equal(y[1], reference::from_shortest_decimal<reference::BigReal>(m.v0[1]) - x[1] / 4, "v2",
                 reference::BigReal(1));
  }
}

// The same with b2 and a constant force: with kappa = b2/a2, mu = 1 - alpha, v1 = v1(0) - g1 t, at t = 1
//   v2 = v2(0) E_mu(-kappa) - (b1/a2) (v1(0) E_{mu,1+mu}(-kappa) - g1 E_{mu,2+mu}(-kappa)).
TEST(AlgebraicLinearSystem, RelaxesBehindAFallingCoordinate) {
  const auto precision = test_precision();
  const Motion m{
      .alpha = 0.3, .rest = 0.7, .k = {0.0, 1.0}, .g = {1.5, 2.0}, .a = {0.0, 2.0}, .b = {0.5, 1.0}};
  const auto v =
      digits_at(reference::linear_reference(with_multiplier(m, OutputChoice::velocities_and_memory)), 1.0);
  const auto e = [](const char* beta) {
    return reference::real_part<reference::BigReal>(mittag_leffler_digits("0.7", beta, "-0.5"));
  };
  const auto v1 = reference::from_shortest_decimal<reference::BigReal>(m.v0[0]),
             v2 = reference::from_shortest_decimal<reference::BigReal>(m.v0[1]);
  expect_equal(v[1],
               reference::BigReal(v2 * e("1") - (v1 * e("1.7") - reference::BigReal("1.5") * e("2.7")) / 4),
               "v2", reference::BigReal(1));
}

// alpha = 1: w = v is also a row of order 0. For alpha = 1 - 1e-16 the solution differs by rounding, as
// t^1e-16 is 1.
TEST(AlgebraicLinearSystem, IsContinuousAtOrderOne) {
  const Motion next{.alpha = 1.0 - 0x1p-53, .rest = 0x1p-53};
  const Motion one{.alpha = 1.0, .rest = 0.0};
  const reference::Reference limit = reference::linear_reference(
                                 with_multiplier(one, OutputChoice::positions_and_memory)),
                             solution = reference::linear_reference(
                                 with_multiplier(next, OutputChoice::positions_and_memory));
  for (const double t : {0.01, 1.0, 10.0}) {
    const Vec difference = solution.at(t).value - limit.at(t).value;
    EXPECT_LE(difference.cwiseAbs().maxCoeff(), 1e-14) << t;
  }
}

// D^alpha p = w with 0 = p - q uses alpha exactly, and the same rows serve orders up to 2.
TEST(AlgebraicLinearSystem, MayHaveTheMemoryOnACopy) {
  const auto precision = test_precision();
  const Motion m;
  const reference::Reference on_velocity = reference::linear_reference(
                                 with_multiplier(m, OutputChoice::positions_and_memory)),
                             on_copy = reference::linear_reference(with_memory_on_copies(m));
  const Oscillator o{"", 1.75, 0.75, 0.25, 0.0};
  const Motion fast{.alpha = o.alpha};
  const reference::Reference above = reference::linear_reference(
                                 with_multiplier_above_one(fast, o.above, o.below)),
                             copy_above = reference::linear_reference(with_memory_on_copies(fast));
  for (const double t : {0.5, 5.0}) {
    const auto x = digits_at(on_velocity, t), y = digits_at(on_copy, t), u = digits_at(above, t),
               w = digits_at(copy_above, t);
    for (std::size_t i = 0; i < 2; ++i) {
      expect_equal(x[i], y[i], "q", reference::BigReal(1));
      expect_equal(x[2 + i], y[2 + i], "w", reference::BigReal(1));
      expect_equal(u[i], w[i], "q", reference::BigReal(1));
      expect_equal(u[4 + i], w[2 + i], "w", reference::BigReal(1));
    }
  }
}

// lambda = (a.grad u - b.(d/dt) w) / |a|^2 starts like t^-alpha.
TEST(AlgebraicLinearSystem, MultiplierIsInfiniteAtTheStart) {
  reference::LinearSystem system = with_multiplier({.v0 = {3.0, 0.25}}, OutputChoice::velocities_and_memory);
  system.outputs = {multiplier_component};
  const reference::Reference multiplier = reference::linear_reference(system);
  EXPECT_EQ(multiplier.at(0.0).value[0], -std::numeric_limits<double>::infinity());
  // b.v(0) / (|a|^2 Gamma(1/2)) = 1.425 / (5 sqrt(pi))
  EXPECT_NEAR(multiplier.at(1e-12).value[0] * 1e-6, -0.285 / std::sqrt(std::numbers::pi), 1e-5);
}

// b = -2a for alpha near 1: a.v (1 - 2 t^1e-16) = C0 grows with the rate 2^(1e16).
TEST(AlgebraicLinearSystem, SaysWhatGrowsAtOnce) {
  const Motion next{.alpha = 1.0 - 0x1p-53, .rest = 0x1p-53, .b = {-2.0, -4.0}};
  EXPECT_THROW(
      reference::linear_reference(with_multiplier(next, OutputChoice::velocities_and_memory)).at(1.0),
      std::runtime_error);
}

TEST(AlgebraicLinearSystem, RefusesWhatDeterminesNothing) {
  Motion m;
  m.a = {0.0, 0.0};
  EXPECT_THROW(reference::linear_reference(with_multiplier(m, OutputChoice::velocities_and_memory)),
               std::invalid_argument);
  reference::LinearSystem system = with_multiplier(Motion{}, OutputChoice::velocities_and_memory);
  system.outputs = {9};
  EXPECT_THROW(reference::linear_reference(system), std::invalid_argument);
}

}  // namespace
}  // namespace fde::bench
