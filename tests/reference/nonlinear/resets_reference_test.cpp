// SPDX-License-Identifier: MIT
// References of problems in which events set unknowns: the history goes on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/reference/nonlinear/collocation.hpp"
#include "fdebench/reference/nonlinear/march/reset_locator.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/exact_values.hpp"

namespace fde::reference {
namespace {

using bench::expect_exact;
using testing::HasSubstr;

class ResetsOfOrder : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Orders, ResetsOfOrder, testing::Values(0.3, 0.6, 1.0, 1.6),
                         [](const auto& test) { return std::to_string(std::lround(10 * test.param)); });

// Doses d at 1 and 2 decay as the first one does: x = r(t) + d r(t - 1) + d r(t - 2), r(t) = E_g(-t^g).
TEST_P(ResetsOfOrder, AddDosesAtGivenTimes) {
  const double order = GetParam(), dose = 2.0;
  const std::vector<double> initial = order > 1.0 ? std::vector{1.0, 0.0} : std::vector{1.0};
  const Problem problem{.components = {{order, initial}},
                        .rhs = [](double, In y, Out f) { f = -y; },
                        .end = 2.75,
                        .resets = {{.value = [](double t, In) { return (t - 1.0) * (2.0 - t) * (t - 7.0); },
                                    .state = [=](double, In, Out y) { y[0] += dose; }}}};
  const Reference reference = reference_solution(problem);
  const auto decay = [&](double t) {
    return t < 0.0 ? 0.0 : mittag_leffler(order, 1.0, -std::pow(t, order));
  };
  // At the time of a dose it has not been taken.
  for (const double t : {0.25, 1.0, 1.125, 1.75, 2.0, 2.5, 2.75}) {
    const double exact =
        decay(t) + (t > 1.0 ? dose * decay(t - 1.0) : 0.0) + (t > 2.0 ? dose * decay(t - 2.0) : 0.0);
    expect_exact(reference, t, Vec::Constant(1, exact), 1e-13);
  }
}

// D^g x = 1 with x set to 0 where it is 1: x = t^g / Gamma(g+1) less its integer part.
TEST_P(ResetsOfOrder, LeaveTheFractionOfAGrowingPower) {
  const double order = GetParam();
  const Problem problem{.components = {{order, std::vector<double>(order > 1.0 ? 2 : 1, 0.0)}},
                        .rhs = [](double, In, Out f) { f[0] = 1.0; },
                        .end = 5.0,
                        .resets = {{.value = [](double, In y) { return y[0] - 1.0; },
                                    .state = [](double, In, Out y) { y[0] = 0.0; }}}};
  const Reference reference = reference_solution(problem);
  for (const double t : {0.5, 1.7, 3.3, 4.9}) {
    const double power = std::pow(t, order) / std::tgamma(order + 1.0);
    expect_exact(reference, t, Vec::Constant(1, power - std::floor(power)), 1e-12);
  }
}

// A ball that keeps 0.8 of its velocity: it falls from 1 and is at the ground at sqrt(2), where its velocity
// is -sqrt(2), and again 1.6 sqrt(2) later.
Problem ball(double kept, Crossing crossing, double end) {
  return {.components = {{1.0, {1.0}}, {1.0, {0.0}}},
          .rhs = [](double, In y, Out f) { f << y[1], -1.0; },
          .end = end,
          .resets = {{.value = [](double, In y) { return y[0]; },
                      .crossing = crossing,
                      .state = [=](double, In, Out y) { y[1] *= -kept; }}}};
}

TEST(ResetsReference, LetABallBounce) {
  const double first = std::sqrt(2.0);
  for (const auto crossing : {Crossing::falling, Crossing::either}) {
    const Reference reference = reference_solution(ball(0.8, crossing, 5.0));
    for (const double t : {1.0, 1.5, 3.0, 4.0, 5.0}) {
      const double bounced = t < first ? 0.0 : t < 2.6 * first ? first : 2.6 * first;
      const double speed = t < first         ? 0.0
                           : t < 2.6 * first ? 0.8 * first
                                             : 0.64 * first,
                   since = t - bounced;
      const double from = t < first ? 1.0 : 0.0;
      expect_exact(reference, t, Vec{{from + speed * since - since * since / 2.0, speed - since}}, 1e-13);
    }
  }
}

// At a double next to the time of the bounce it is not known whether the ball has bounced.
TEST(ResetsReference, ContainBothSidesNextToAnEvent) {
  const double first = std::sqrt(2.0);
  for (const double end : {5.0, first, std::nextafter(first, 0.0), std::nextafter(first, 2.0)}) {
    const Reference reference = reference_solution(ball(0.8, Crossing::falling, end));
    for (const double t : {first, std::nextafter(first, 0.0)}) {
      if (t > end) continue;
      const auto [value, bound] = reference.at(t);
      EXPECT_NEAR(value[1], -first, bound[1]) << end;
      EXPECT_NEAR(value[1], 0.8 * first, bound[1]) << end;
      EXPECT_LT(bound[0], 1e-12) << end;
    }
    expect_exact(reference, 1.25, Vec{{1.0 - 1.25 * 1.25 / 2.0, -1.25}}, 1e-13);
  }
}

// x = t - 1 passes through 0, where v, which is at rest otherwise, becomes 1: x goes on to the other side.
TEST(ResetsReference, LetAFunctionGoOnThroughItsZero) {
  for (const auto crossing : {Crossing::rising, Crossing::either}) {
    const Problem problem{.components = {{1.0, {-1.0}}, {0.5, {0.0}}},
                          .rhs = [](double, In, Out f) { f << 1.0, 0.0; },
                          .end = 3.0,
                          .resets = {{.value = [](double, In y) { return y[0]; },
                                      .crossing = crossing,
                                      .state = [](double, In, Out y) { y[1] += 1.0; }}}};
    expect_exact(reference_solution(problem), 2.0, Vec{{1.0, 1.0}}, 1e-13);
  }
}

// z = 1 - x, an algebraic row, jumps with x: D^1/2 x = z, so x = 1 - r(t) + r(t - 1) and z = 1 - x.
TEST(ResetsReference, TakeAlgebraicRowsAlong) {
  const Problem problem{.components = {{0.5, {0.0}}, {0.0, {1.0}}},
                        .rhs = [](double, In y, Out f) { f << y[1], 1.0 - y[0] - y[1]; },
                        .end = 2.0,
                        .resets = {{.value = [](double t, In) { return t - 1.0; },
                                    .state = [](double, In, Out y) { y[0] += 1.0; }}}};
  const Reference reference = reference_solution(problem);
  const auto decay = [](double t) { return mittag_leffler(0.5, 1.0, -std::sqrt(t)); };
  for (const double t : {0.5, 1.001, 1.5, 2.0}) {
    const double x = 1.0 - decay(t) + (t > 1.0 ? decay(t - 1.0) : 0.0);
    expect_exact(reference, t, Vec{{x, 1.0 - x}}, 1e-9);
  }
}

// Behind infinitely many bounces up to t = 3 sqrt(2) there is no solution.
TEST(ResetsReference, RefuseEventsWithoutEnd) {
  EXPECT_THAT([] { reference_solution(ball(0.5, Crossing::falling, 5.0)); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("follows another within rounding")));
  auto late = ball(0.8, Crossing::falling, 5.0);
  late.delays.lags = {1.0};
  EXPECT_THAT([&] { reference_solution(late); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("only without delays")));
}

TEST(ResetsReference, AreNotMoreThanAHundred) {
  auto ticks = ball(0.0, Crossing::either, 100.0);
  ticks.resets[0].value = [](double t, In) { return std::sin(10.0 * t); };
  ResetLocator locator(ticks);
  const auto at_rest = [](double) -> Vec { return Vec::Zero(2); };
  const auto passes = [&](double to) {
    double from = locator.events().empty() ? 0.0 : locator.events().back().t;
    while (const auto event = locator.find(from, to, at_rest)) {
      locator.accept(from, *event, at_rest);
      Vec y = Vec::Zero(2);
      locator.pass(y);
      from = *event;
    }
  };
  passes(31.5);
  ASSERT_EQ(locator.events().size(), 100U);
  for (std::size_t k = 0; k < 100; ++k)
    EXPECT_NEAR(locator.events()[k].t, (static_cast<double>(k) + 1.0) * std::numbers::pi / 10.0, 1e-14) << k;
  EXPECT_THAT([&] { passes(32.0); }, testing::ThrowsMessage<std::runtime_error>(
                                         HasSubstr("more than 100 events that set unknowns")));
}

}  // namespace
}  // namespace fde::reference
