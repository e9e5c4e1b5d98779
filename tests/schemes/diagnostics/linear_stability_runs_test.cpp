// SPDX-License-Identifier: MIT
// Runs decay inside the stability regions and grow outside.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/programs/stability/late_growth.hpp"
#include "fdebench/schemes/diagnostics/stability_region.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct StabilityCase {
  std::string_view scheme;
  double tolerance;
  int steps;
};

class Interval : public testing::TestWithParam<StabilityCase> {};

TEST_P(Interval, EndsWhereRunsBeginToGrow) {
  const double tolerance = GetParam().tolerance;
  const int steps = GetParam().steps;
  const Scheme& scheme = *find_scheme(GetParam().scheme);
  for (int i = 1; i < 20; ++i) {
    const double order = 0.1 * i, x = real_stability_interval(scheme, order);
    if (std::isinf(x)) {
      EXPECT_TRUE(decays(late_growth(scheme, test_problem(scheme, order, -1e3), 1.0, steps))) << order;
      continue;
    }
    const auto at = [&](double factor) {
      return late_growth(scheme, test_problem(scheme, order, -factor * x), 1.0, steps);
    };
    EXPECT_TRUE(decays(at(1.0 - tolerance))) << order;
    EXPECT_TRUE(grows(at(1.0 + tolerance))) << order;
  }
}

// Near the boundary the modes of the split scheme grow more slowly and need more steps.
INSTANTIATE_TEST_SUITE_P(Schemes, Interval,
                         testing::Values(StabilityCase{"adams_pc", 1e-3, 10000},
                                         StabilityCase{"decoupled_multi_order", 1e-3, 20000},
                                         StabilityCase{"product_trapezoidal", 1e-3, 10000},
                                         StabilityCase{"l1", 1e-3, 3000},
                                         StabilityCase{"grunwald_letnikov", 1e-3, 3000},
                                         StabilityCase{"commensurate_adams_pc", 5e-2, 6000},
                                         StabilityCase{"multi_term_pc", 1e-3, 10000}),
                         [](const auto& test) { return std::string(test.param.scheme); });

// Complex lambda on both sides of the boundary; count_growing_modes determines which side is stable.
class Boundary : public testing::TestWithParam<const Scheme*> {};

TEST_P(Boundary, IsWhereRunsBeginToGrow) {
  int decaying = 0, growing = 0;
  for (const double order : {0.3, 0.7, 1.3}) {
    for (const double theta : {0.5, 1.5, 2.5}) {
      for (const ComplexValue z : root_locus(*GetParam(), order, theta)) {
        for (const double side : {1.0, -1.0}) {
          const Problem problem = test_problem(
              *GetParam(), order, z + side * boundary_normal(*GetParam(), order, theta, z, 0.01));
          const bool expected = is_linearly_stable(*GetParam(), problem, 1.0);
          const LateGrowth x = late_growth(*GetParam(), problem, 1.0, 4000);
          EXPECT_TRUE(expected ? decays(x) : grows(x)) << order << ' ' << theta << ' ' << side;
          ++(expected ? decaying : growing);
        }
      }
    }
  }
  EXPECT_GE(decaying, 3);
  EXPECT_GE(growing, 9);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Boundary, testing::ValuesIn(schemes_with_symbol()), id_of_param);

// The damped chain of Yin, Liu & Anh: runs with step sizes below and above the largest stable one.
TEST(Chain, LargestStableStepIsWhereRunsBeginToGrow) {
  for (const auto& orders : {std::pair{1.5, 0.5}, {1.25, 0.75}, {1.9, 0.1}}) {
    const Problem problem =
        scene_of("damped_oscillator",
                 {{"alpha", orders.first}, {"beta", orders.second}, {"mu", 1.0}, {"nu", 1.0}})
            .problem;
    const Scheme& scheme = *find_scheme("decoupled_multi_order");
    const double h = largest_stable_step(scheme, problem, 0.1, 10.0);
    EXPECT_TRUE(decays(late_growth(scheme, problem, 0.98 * h, 6000))) << orders.first;
    EXPECT_TRUE(grows(late_growth(scheme, problem, 1.02 * h, 6000))) << orders.first;
  }
}

// For large mu the last link, D^(2-alpha) v = -mu tau^alpha v, determines the stability limit.
TEST(Chain, StrongDampingEndsAsItsLinkDoes) {
  constexpr double mu = 100.0, tau = 0.8;
  for (const double alpha : {1.25, 1.5}) {
    const Problem problem =
        scene_of("damped_oscillator", {{"alpha", alpha}, {"beta", 0.5}, {"mu", mu}, {"tau", tau}}).problem;
    const double end = std::pow(std::tgamma(4.0 - alpha) / (mu * std::pow(tau, alpha)), 1.0 / (2.0 - alpha));
    EXPECT_NEAR(largest_stable_step(*find_scheme("adams_pc"), problem, 0.5 * end, 10.0) / end, 1.0, 0.02);
  }
}

// 1/K of each link is in its sector, so all terms of det M are in one half plane: every step size is stable.
TEST(Chain, ImplicitRulesAreStableWithAnyStep) {
  for (const auto& orders : {std::pair{1.5, 0.5}, {1.25, 0.75}, {1.9, 0.1}}) {
    for (const auto& strengths : {std::pair{0.06, 0.1}, {0.0, 100.0}, {100.0, 0.1}}) {
      const Problem problem = scene_of("damped_oscillator", {{"alpha", orders.first},
                                                             {"beta", orders.second},
                                                             {"mu", strengths.first},
                                                             {"nu", strengths.second}})
                                  .problem;
      for (const auto* id : {"l1", "grunwald_letnikov", "product_trapezoidal"}) {
        for (const double h : {0.1, 3.0, 1e3})
          EXPECT_TRUE(is_linearly_stable(*find_scheme(id), problem, h)) << id << h;
      }
    }
  }
}

}  // namespace
}  // namespace fde::bench
