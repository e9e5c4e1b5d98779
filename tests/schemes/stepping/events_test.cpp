// SPDX-License-Identifier: MIT
// Event location (zeros of functions along the solution) in every scheme with adaptive step size.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/adaptive_schemes.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

class Events : public testing::TestWithParam<const Scheme*> {
 protected:
  static Trajectory run(const Problem& problem, double accuracy, const Options& options) {
    return GetParam()->solve(problem, Tolerance{accuracy, accuracy}, options);
  }
  static std::vector<double> times(const Trajectory& path) {
    std::vector<double> result;
    for (const auto& one : path.events) result.push_back(one.t);
    return result;
  }
};

// y = 2 sqrt(t / pi), which one step may solve.
Problem half_integral(double end = 2.0) {
  return {.components = {{0.5, {0.0}}}, .rhs = [](double, In, Out f) { f[0] = 1.0; }, .end = end};
}

Event reaches(double level) {
  return {.value = [level](double, In y) { return y[0] - level; }};
}

// t with 2 sqrt(t / pi) = level.
double time_of(double level) { return M_PI / 4.0 * level * level; }

constexpr double ulps = 4e-16;

// y = 1 at pi / 4.
TEST_P(Events, AreLocatedToRounding) {
  for (const double level : {1e-3, 0.2, 1.0, 1.5}) {
    const auto path = run(half_integral(), 1e-6, {.events = {reaches(level)}});
    ASSERT_EQ(path.events.size(), 1U) << level;
    EXPECT_NEAR(path.events[0].t / time_of(level), 1.0, 4 * ulps) << level;
    EXPECT_NEAR(path.events[0].y[0] / level, 1.0, 4 * ulps) << level;
  }
}

// y = 1 - t reaches 0.5 before it leaves the domain y > 0, in a step that may do both.
TEST_P(Events, EndARunBeforeItLeavesItsDomain) {
  Problem problem{.components = {{1.0, {1.0}}}, .rhs = [](double, In, Out f) { f[0] = -1.0; }, .end = 2.0};
  problem.domain = {.edge = "y = 0", .margin = [](double, In y) { return y[0]; }};
  const Event halved{.value = [](double, In y) { return y[0] - 0.5; }, .terminal = true};
  const auto path = run(problem, 1e-6, {.events = {halved}});
  EXPECT_EQ(path.status, SolveStatus::terminal_event);
  EXPECT_NEAR(path.last_time, 0.5, 4 * ulps);
}

// E_g(-t^g) is decreasing: it takes its value at t = 0.37 there only.
TEST_P(Events, AreLocatedAsWellAsTheSolutionIsKnown) {
  const double accuracy = GetParam()->id == "spectral_collocation" ? 1e-12 : 1e-6, at = 0.37;
  for (const double order : {0.3, 0.5, 0.9}) {
    const Problem problem{.components = {{order, {1.0}}},
                          .rhs = [](double, In y, Out f) { f = -y; },
                          .derivatives = DenseLinearPart{-Matrix::Identity(1, 1)}};
    const double level = reference::mittag_leffler(order, 1.0, -std::pow(at, order));
    const auto path = run(problem, accuracy, {.events = {reaches(level)}});
    ASSERT_EQ(path.events.size(), 1U) << order;
    EXPECT_NEAR(path.events[0].t, at, 20.0 * accuracy) << order;
  }
}

TEST_P(Events, OfOneStepComeInTheOrderOfTime) {
  const Event close{.value = [](double t, In) { return (t - 0.3) * (t - 0.301); }};
  const auto path = run(half_integral(), 1e-3, {.events = {reaches(1.0), close, reaches(0.5)}});
  ASSERT_EQ(path.events.size(), 4U);
  const std::vector<std::size_t> numbers{2, 1, 1, 0};
  const std::vector<double> exact{time_of(0.5), 0.3, 0.301, time_of(1.0)};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_EQ(path.events[i].event, numbers[i]);
    EXPECT_NEAR(path.events[i].t, exact[i], 4 * ulps) << i;
  }
}

// sin(w t) has floor(10 w / pi) zeros up to 10, however long the steps are that the solution needs.
TEST_P(Events, AreAllFoundWhereAFunctionOscillatesWithinSteps) {
  for (const double rate : {20.0, 300.0}) {
    const Event wave{.value = [rate](double t, In) { return std::sin(rate * t); }};
    const auto path = run(half_integral(10.0), 1e-5, {.events = {wave}});
    ASSERT_EQ(path.events.size(), static_cast<std::size_t>(10.0 * rate / M_PI)) << rate;
    for (std::size_t k = 0; k < path.events.size(); ++k)
      EXPECT_NEAR(path.events[k].t, static_cast<double>(k + 1) * M_PI / rate, 1e-13);
  }
}

// A function that jumps through 0 has one zero, at its jump; rounding noise around 0 ends the search.
TEST_P(Events, AreFoundWhereAFunctionJumps) {
  const Event jumps{.value = [](double t, In) { return t < 0.123456 ? -1.0 : 1.0; }};
  const Event noise{.value = [](double t, In y) { return (y[0] + 1.0) - y[0] - 1.0 + 0.0 * t; }};
  const auto path = run(half_integral(), 1e-5, {.events = {jumps}});
  ASSERT_EQ(path.events.size(), 1U);
  EXPECT_NEAR(path.events[0].t, 0.123456, ulps);
  EXPECT_EQ(run(half_integral(), 1e-3, {.events = {noise}}).status, SolveStatus::finished);
}

// cos t, of order 2: rising where the sine is negative.
TEST_P(Events, CountInTheirDirection) {
  const Problem problem{.components = {{2.0, {1.0, 0.0}}},
                        .rhs = [](double, In y, Out f) { f = -y; },
                        .derivatives = DenseLinearPart{-Matrix::Identity(1, 1)},
                        .end = 9.0};
  const auto zeros = [&](Crossing crossing) {
    Event event = reaches(0.0);
    event.crossing = crossing;
    const auto path = run(problem, 1e-5, {.events = {event}});
    for (const auto& one : path.events) EXPECT_EQ(one.y.size(), 1);
    return times(path);
  };
  const auto expect = [](const std::vector<double>& found, const std::vector<double>& halves_of_pi) {
    ASSERT_EQ(found.size(), halves_of_pi.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], halves_of_pi[i] * M_PI / 2.0, 1e-3) << i;
  };
  expect(zeros(Crossing::either), {1, 3, 5});
  expect(zeros(Crossing::rising), {3});
  expect(zeros(Crossing::falling), {1, 5});
}

TEST_P(Events, AreNoneAtTheStartNorWhereAFunctionIsTouchedOrFlat) {
  const Event touched{.value = [](double t, In) { return (t - 0.3) * (t - 0.3); }};
  const Event flat{.value = [](double, In) { return 0.0; }};
  const Event high{.value = [](double t, In) { return 0.25 + 1e-9 - t * (1.0 - t); }};
  const auto path = run(half_integral(), 1e-6, {.events = {reaches(0.0), touched, flat, high}});
  EXPECT_TRUE(path.events.empty());
}

TEST_P(Events, AtAStepAreFoundOnce) {
  Problem problem = half_integral();
  problem.jump_times = {0.5, 1.0};
  const Event at_jump{.value = [](double t, In) { return t - 0.5; }};
  const auto path = run(problem, 1e-6, {.events = {at_jump}});
  ASSERT_EQ(path.events.size(), 1U);
  EXPECT_NEAR(path.events[0].t, 0.5, ulps);
}

TEST_P(Events, EndARunWhereTheyAre) {
  Event last = reaches(1.0);
  last.terminal = true;
  std::vector<double> heard;
  Options options{.events = {reaches(1.5), last, reaches(0.5)}};
  options.observer = [&](double t, In) { heard.push_back(t); };
  const auto path = run(half_integral(), 1e-6, options);
  EXPECT_EQ(path.status, SolveStatus::terminal_event);
  ASSERT_EQ(path.events.size(), 2U);
  EXPECT_EQ(path.events[1].event, 1U);
  EXPECT_NEAR(path.last_time, M_PI / 4.0, 4 * ulps);
  EXPECT_EQ(path.times.back(), path.last_time);
  EXPECT_NEAR(path.y(0, path.y.cols() - 1), 1.0, 4 * ulps);
  EXPECT_EQ(heard, path.times);
  for (const double t : {0.01, 0.3, 0.7})
    EXPECT_NEAR(path.dense_output(t)[0], 2.0 * std::sqrt(t / M_PI), 1e-14) << t;
}

TEST_P(Events, EndARunAfterTheRequestedTimes) {
  Event last = reaches(1.0);
  last.terminal = true;
  const auto path = run(half_integral(), 1e-6, {.output_times = {0.1, 0.7, 0.8, 2.0}, .events = {last}});
  EXPECT_EQ(path.times, (std::vector{0.1, 0.7}));
  EXPECT_EQ(path.y.cols(), 2);
}

// A falling body, y'' = -1 from y = 1/2: at the ground at t = 1, with the velocity -1.
TEST_P(Events, EndAFallAtTheGround) {
  const Problem problem{.components = {{1.0, {0.5}}, {1.0, {0.0}}},
                        .rhs = [](double, In y, Out f) { f << y[1], -1.0; },
                        .end = 5.0};
  Event ground = reaches(0.0);
  ground.crossing = Crossing::falling;
  ground.terminal = true;
  const auto path = run(problem, 1e-8, {.events = {ground}});
  EXPECT_NEAR(path.last_time, 1.0, 1e-7);
  EXPECT_NEAR(path.y(1, path.y.cols() - 1), -1.0, 1e-7);
}

// Events do not change the solution.
TEST_P(Events, DoNotChangeTheSolution) {
  const Scene scene = scene_of("brusselator", {{"gamma", 0.8}});
  Problem problem = scene.problem;
  problem.end = 5.0;
  const auto path = run(problem, 1e-4, {.events = {reaches(0.5)}}), alone = run(problem, 1e-4, {});
  EXPECT_EQ(path.times, alone.times);
  EXPECT_EQ(path.y, alone.y);
  EXPECT_FALSE(path.events.empty());
}

// Events are located after jumps and switches too: y = 2 sqrt(t / pi) up to 1 at pi / 4, then D^0.5 y = 2.
TEST_P(Events, AreLocatedAfterASwitch) {
  const double at = 1.1, level = solution_of_switching_problem(at);
  const auto path = run(switching_problem(), 1e-6, {.events = {reaches(level)}});
  ASSERT_EQ(path.events.size(), 1U);
  EXPECT_NEAR(path.events[0].t, at, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Events, testing::ValuesIn(adaptive_schemes()), id_of_param);

TEST(EventsOverAGrid, AreRefused) {
  expect_message([] { solve("l1", half_integral(), 8, {.events = {reaches(1.0)}}); }, "not over a grid");
}

}  // namespace
}  // namespace fde::bench
