// SPDX-License-Identifier: MIT
// Events at which y jumps: the history goes on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/adaptive_schemes.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using testing::HasSubstr;

constexpr double accuracy = 1e-7;

class Resets : public testing::TestWithParam<const Scheme*> {
 protected:
  static Trajectory run(const Problem& problem, const Options& options = {}) {
    const Tolerance tolerance{accuracy, accuracy};
    EXPECT_EQ(unsupported_reason(*GetParam(), problem, tolerance), std::nullopt);
    return GetParam()->solve(problem, tolerance, options);
  }
};

// D^g x = 1 with x set to 0 where it is 1: x = t^g / Gamma(g+1) less its integer part.
TEST_P(Resets, OfAGrowingPowerLeaveItsFraction) {
  for (const double order : {0.4, 0.8, 1.0}) {
    const Problem problem{.components = {{order, {0.0}}},
                          .rhs = [](double, In, Out f) { f[0] = 1.0; },
                          .end = 5.0,
                          .resets = {{.value = [](double, In y) { return y[0] - 1.0; },
                                      .state = [](double, In, Out y) { y[0] = 0.0; }}}};
    const std::vector<double> times{0.5, 1.7, 3.3, 4.9};
    const auto path = run(problem, {.output_times = times});
    ASSERT_EQ(path.status, SolveStatus::finished) << order;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double power = std::pow(times[i], order) / std::tgamma(order + 1.0);
      EXPECT_NEAR(path.y(0, static_cast<Eigen::Index>(i)), power - std::floor(power), 20.0 * accuracy)
          << order << ' ' << times[i];
    }
  }
}

// A dose d at t_1 decays as the first one does: x = E(-t^g) + d E(-(t - t_1)^g).
TEST_P(Resets, AddDosesAtGivenTimes) {
  const double order = 0.6, dose = 2.0, at = 1.25;
  const Problem problem{.components = {{order, {1.0}}},
                        .rhs = [](double, In y, Out f) { f = -y; },
                        .derivatives = DenseLinearPart{Matrix::Constant(1, 1, -1.0)},
                        .end = 3.0,
                        .resets = {{.value = [=](double t, In) { return t - at; },
                                    .state = [=](double, In, Out y) { y[0] += dose; }}}};
  const auto decay = [=](double t) { return reference::mittag_leffler(order, 1.0, -std::pow(t, order)); };
  std::vector<double> seen;
  const auto path = run(problem, {.observer = [&](double t, In y) {
                          const double exact = decay(t) + (t > at ? dose * decay(t - at) : 0.0);
                          if (std::abs(t - at) > 1e-9) {
                            EXPECT_NEAR(y[0], exact, 20.0 * accuracy) << t;
                          }
                          seen.push_back(t);
                        }});
  EXPECT_EQ(seen, path.times);
  EXPECT_NEAR(path.y(0, path.y.cols() - 1), decay(3.0) + dose * decay(3.0 - at), 20.0 * accuracy);
  if (path.dense_output) {
    EXPECT_NEAR(path.dense_output(1.2)[0], decay(1.2), 20.0 * accuracy);
    EXPECT_NEAR(path.dense_output(1.3)[0], decay(1.3) + dose * decay(1.3 - at), 100.0 * accuracy);
  }
}

// A ball that keeps 0.8 of its velocity: it falls from 1 and is at the ground at sqrt(2), where its velocity
// is -sqrt(2), and again 1.6 sqrt(2) later. The events have the state before it is set.
TEST_P(Resets, LetABallBounce) {
  const Event ground{.value = [](double, In y) { return y[0]; }, .crossing = Crossing::falling};
  const Problem problem{
      .components = {{1.0, {1.0}}, {1.0, {0.0}}},
      .rhs = [](double, In y, Out f) { f << y[1], -1.0; },
      .end = 5.0,
      .resets = {{.value = ground.value, .crossing = Crossing::falling, .state = [](double, In y, Out after) {
                    after << 0.0, -0.8 * y[1];
                  }}}};
  const auto path = run(problem, {.events = {ground}});
  ASSERT_EQ(path.status, SolveStatus::finished);
  ASSERT_EQ(path.events.size(), 2U);
  const double first = std::sqrt(2.0);
  EXPECT_NEAR(path.events[0].t, first, 20.0 * accuracy);
  EXPECT_NEAR(path.events[0].y[1], -first, 20.0 * accuracy);
  EXPECT_NEAR(path.events[1].t, 2.6 * first, 50.0 * accuracy);
  EXPECT_NEAR(path.events[1].y[1], -0.8 * first, 50.0 * accuracy);
  const double left = 5.0 - 2.6 * first;
  EXPECT_NEAR(path.y(0, path.y.cols() - 1), 0.64 * first * left - left * left / 2.0, 100.0 * accuracy);
}

// Its place is not set, so that it is at the ground to rounding, on either side, when it bounces.
TEST_P(Resets, LeaveAZeroOnTheSideToWhichTheStateMoves) {
  for (const auto crossing : {Crossing::falling, Crossing::either}) {
    const Problem problem{.components = {{1.0, {1.0}}, {1.0, {0.0}}},
                          .rhs = [](double, In y, Out f) { f << y[1], -1.0; },
                          .end = 3.0,
                          .resets = {{.value = [](double, In y) { return y[0]; },
                                      .crossing = crossing,
                                      .state = [](double, In, Out y) { y[1] *= -0.8; }}}};
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      const auto path = GetParam()->solve(problem, Tolerance{tolerance, tolerance}, {});
      ASSERT_EQ(path.status, SolveStatus::finished) << tolerance;
      const double first = std::sqrt(2.0), since = 3.0 - first;
      EXPECT_NEAR(path.y(0, path.y.cols() - 1), 0.8 * first * since - since * since / 2.0, 20.0 * tolerance)
          << tolerance;
    }
  }
}

// D^1/2 x = 2 - x is at 1 at t_1, where it is set next to 1 and rises on. So it is 2 (1 - E(-t^1/2)), with
// E(z) = E_1/2,1(z), also behind t_1.
TEST_P(Resets, NextToTheirZeroLetTheHistoryGoOn) {
  const Problem problem{.components = {{0.5, {0.0}}},
                        .rhs = [](double, In y, Out f) { f[0] = 2.0 - y[0]; },
                        .end = 4.0,
                        .resets = {{.value = [](double, In y) { return y[0] - 1.0; },
                                    .state = [](double, In, Out y) { y[0] = 1.0 - 1e-13; }}}};
  const auto path = run(problem, {.budget = 20.0});
  ASSERT_EQ(path.status, SolveStatus::finished);
  const double exact = 2.0 - 2.0 * reference::mittag_leffler(0.5, 1.0, -2.0);
  EXPECT_NEAR(path.y(0, path.y.cols() - 1), exact, 20.0 * accuracy);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Resets, testing::ValuesIn(adaptive_schemes()), id_of_param);

TEST(ResetsOverAGrid, AreRefused) {
  Problem problem{.components = {{0.5, {0.0}}}, .rhs = [](double, In, Out f) { f[0] = 1.0; }};
  problem.resets.push_back({});
  const auto reason = unsupported_reason(*find_scheme("l1"), problem, Grid{.steps = 8});
  ASSERT_TRUE(reason);
  EXPECT_THAT(*reason, HasSubstr("locates no events"));
}

}  // namespace
}  // namespace fde::bench
