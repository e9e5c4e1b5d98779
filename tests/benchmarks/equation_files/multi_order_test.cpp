// SPDX-License-Identifier: MIT
// The system of three orders in docs/examples, whose right-hand side contains 0^(1/6) at t = 0.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(MultiOrder, HasTheExactSolutionOfItsFile) {
  const Scene scene = scene_of_example("multi_order.toml");
  for (const double t : {0.0, 0.3, 1.0}) {
    const auto known = scene.reference.at(t);
    const Vec exact = (Vec(3) << t + 1.0, std::pow(t, 1.2) + 0.5, std::pow(t, 1.8) + 0.3).finished();
    EXPECT_LT((known.value - exact).cwiseAbs().maxCoeff(), 4e-16);
    EXPECT_LT(known.bound.maxCoeff(), 4e-16);
  }
}

TEST(MultiOrder, IsSolvedByItsSolution) {
  const Scene scene = scene_of_example("multi_order.toml");
  const double t = 0.37;
  Vec f(3);
  scene.problem.rhs(t, (Vec(3) << t + 1.0, std::pow(t, 1.2) + 0.5, std::pow(t, 1.8) + 0.3).finished(), f);
  // D^0.5 t = t^0.5 / Gamma(1.5), D^0.2 t^1.2 = Gamma(2.2) t, D^0.6 t^1.8 = Gamma(2.8) / Gamma(2.2) t^1.2
  EXPECT_NEAR(f[0], std::sqrt(t) / std::tgamma(1.5), 1e-14);
  EXPECT_NEAR(f[1], std::tgamma(2.2) * t, 1e-14);
  EXPECT_NEAR(f[2], std::tgamma(2.8) / std::tgamma(2.2) * std::pow(t, 1.2), 1e-14);
}

class MultiOrderConvergence : public testing::TestWithParam<const Scheme*> {};

// Derivatives are infinite at t = 0: four times as many steps must give less than half the error.
TEST_P(MultiOrderConvergence, IsThatOfAtLeastHalfTheSteps) {
  const Scene scene = scene_of_example("multi_order.toml");
  const auto error = [&](int steps) {
    const auto path = solve(GetParam()->id, scene.problem, steps, {.output_times = {1.0}});
    EXPECT_EQ(path.status, SolveStatus::finished) << describe(scene.problem, path);
    return (path.y.col(0) - (Vec(3) << 2.0, 1.5, 1.3).finished()).cwiseAbs().maxCoeff();
  };
  const double coarse = error(512), fine = error(2048);
  EXPECT_LT(fine, coarse / 2.0);
  EXPECT_LT(fine, 3e-2);
}

INSTANTIATE_TEST_SUITE_P(OfEveryScheme, MultiOrderConvergence, testing::ValuesIn(row_schemes()), id_of_param);

// Near the start y3 - 0.3 = t^1.8 is within rounding, and the derivative of its sixth root is infinite.
// f as a function of y alone is what problems of C++ and Python give.
TEST(MultiOrder, IsSolvedToTheAccuracyAsked) {
  Scene scene = scene_of_example("multi_order.toml");
  scene.problem.increments = {};
  const std::vector<std::pair<std::string, double>> asked{{"spectral_collocation", 1e-6},
                                                          {"spectral_collocation", 3e-10},
                                                          {"spectral_collocation", 1e-11},
                                                          {"radau_exponentials", 1e-4},
                                                          {"radau_exponentials", 1e-9}};
  for (const auto& [id, accuracy] : asked) {
    const auto path = solve(id, scene.problem, Tolerance{accuracy, accuracy}, {.output_times = {0.1, 1.0}});
    ASSERT_EQ(path.status, SolveStatus::finished) << id << accuracy;
    for (Eigen::Index c = 0; c < path.y.cols(); ++c) {
      const Vec exact = scene.reference.at(path.time(c)).value, error = (path.y.col(c) - exact).cwiseAbs();
      EXPECT_LE((error.array() / (1.0 + exact.array())).maxCoeff(), 10.0 * accuracy) << path.time(c);
    }
  }
}

// It computes y - y(0), in which the start has a relative accuracy, and reaches the accuracy at all times.
TEST(MultiOrder, IsSolvedOnPanelsToTheAccuracyAskedAtAllTimes) {
  const Scene scene = scene_of_example("multi_order.toml");
  for (const double accuracy : {1e-3, 1e-6, 1e-8, 1e-10, 1e-11, 1e-12, 1e-13}) {
    const auto path = solve("spectral_collocation", scene.problem, Tolerance{accuracy, accuracy});
    ASSERT_EQ(path.status, SolveStatus::finished) << accuracy;
    EXPECT_LE(path.steps, 40) << accuracy;
    for (Eigen::Index c = 0; c < path.y.cols(); ++c) {
      const double t = path.time(c), between = 0.7 * t;
      for (const double s : {t, between}) {
        const Vec exact = scene.reference.at(s).value, error = (path.dense_output(s) - exact).cwiseAbs();
        EXPECT_LE((error.array() / (1.0 + exact.array())).maxCoeff(), accuracy) << accuracy << ' ' << s;
      }
    }
  }
}

TEST(MultiOrder, HasNoStartPowers) {
  EXPECT_TRUE(scene_of_example("multi_order.toml").smoothness.powers.empty());
}

}  // namespace
}  // namespace fde::bench
