// SPDX-License-Identifier: MIT
// The second method of nonlinear references: its parts, and its results against exact solutions.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "fdebench/reference/nonlinear/diffusive/diffusive_solution.hpp"
#include "fdebench/reference/nonlinear/diffusive/memory.hpp"
#include "fdebench/reference/nonlinear/diffusive/stages.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/testing.hpp"

namespace fde::reference {
namespace {

using ::testing::HasSubstr;

class Order : public testing::TestWithParam<double> {};
class KernelOfOrder : public Order {};
class SolutionOfOrder : public Order {};
class RateOfOrder : public Order {};

// t^(g-1) / Gamma(g), to 2e-16 over 26 decades.
TEST_P(KernelOfOrder, IsASumOfExponentials) {
  const auto g = static_cast<long double>(GetParam());
  const double end = 50.0;
  const DiffusiveKernels sum({GetParam()}, end, 1e-24);
  const auto& weights = sum.kernels[0].weights;
  EXPECT_LT(sum.rates.size(), 350);
  for (double t = end; t > 1e-24 * end; t /= 7.0) {
    long double value = 0.0L;
    for (Eigen::Index m = 0; m < weights.size(); ++m)
      value += static_cast<long double>(weights[m]) * std::exp(-sum.rates[m] * static_cast<long double>(t));
    const long double exact = std::pow(static_cast<long double>(t), g - 1) / std::tgamma(g);
    EXPECT_LT(std::abs(value / exact - 1), 2e-16L) << "t = " << t;
  }
}

INSTANTIATE_TEST_SUITE_P(, KernelOfOrder, testing::Values(1e-3, 0.1, 0.5, 0.9, 0.99, 1 - 1e-6));

// Rate 2s-1: the last row integrates x^(2s-2) exactly, but not x^(2s-1). Collocation: every row integrates
// x^(s-1) exactly.
TEST(RadauRule, HasItsOrder) {
  for (const int stages : {1, 2, 3, 5, 8, 12, 16}) {
    const RadauRule rule(stages);
    const auto integral_of = [&](int power, int row) {
      long double sum = 0.0L;
      for (int j = 0; j < stages; ++j) sum += rule.integral(row, j) * std::pow(rule.nodes[j], power);
      return sum * static_cast<long double>(power + 1);
    };
    EXPECT_NEAR(static_cast<double>(integral_of(2 * stages - 2, stages - 1)), 1.0, 1e-17) << stages;
    if (stages < 8) {
      EXPECT_GT(std::abs(integral_of(2 * stages - 1, stages - 1) - 1.0L), 1e-9L) << stages;
    }
    for (int i = 0; i < stages; ++i) {
      const auto exact = static_cast<double>(std::pow(rule.nodes[i], stages));
      EXPECT_NEAR(static_cast<double>(integral_of(stages - 1, i)), exact, 1e-16) << stages;
    }
  }
  const RadauRule two(2);  // Hairer & Wanner, table IV.5.5
  EXPECT_NEAR(static_cast<double>(two.nodes[0]), 1.0 / 3.0, 1e-17);
  EXPECT_NEAR(static_cast<double>(two.integral(0, 1)), -1.0 / 12.0, 1e-17);
}

TEST(RadauRule, NamesTheStagesThatItHas) {
  EXPECT_THAT([] { RadauRule(17); },
              testing::ThrowsMessage<std::invalid_argument>("Radau method: stages = 17: must be in [1, 16]"));
}

// E_g(-t^g), the relaxation with y(0) = 1, at the ends of all steps from 1e-9 on.
TEST_P(SolutionOfOrder, IsTheMittagLefflerFunction) {
  const double g = GetParam();
  const Problem problem{.components = {{g, g > 1.0 ? std::vector{1.0, 0.0} : std::vector{1.0}}},
                        .rhs = [](double, In y, Out f) { f = -y; },
                        .end = 5.0};
  const auto solution = diffusive_solution(problem);
  EXPECT_EQ(solution.times.back(), 5.0);
  for (std::size_t k = 0; k < solution.times.size(); ++k) {
    const double t = solution.times[k];
    if (t < 1e-9) continue;
    const auto exact = mittag_leffler(g, 1.0, std::complex<double>(-std::pow(t, g))).value.real();
    EXPECT_NEAR(solution.values[k][0], exact, 3e-15) << "t = " << t;
  }
}

TEST_P(SolutionOfOrder, IsThatOfDiethelmFordAndFreed) {
  const auto scene = bench::scene_of("diethelm", {{"gamma", GetParam()}});
  const auto solution = diffusive_solution(scene.problem, {}, {0.1, 0.5, 0.9});
  for (std::size_t k = 0; k < solution.times.size(); ++k) {
    const double t = solution.times[k];
    if (t < 1e-9) continue;
    EXPECT_NEAR(solution.values[k][0], scene.reference.at(t).value[0], 2e-14) << "t = " << t;
  }
}

TEST_P(SolutionOfOrder, IsAPowerOfTime) {
  for (const double p : {2.5, 7.0}) {
    const auto scene = bench::scene_of("power", {{"gamma", GetParam()}, {"p", p}});
    EXPECT_NEAR(diffusive_solution(scene.problem).values.back()[0], 1.0, 1e-14) << p;
  }
}

INSTANTIATE_TEST_SUITE_P(, SolutionOfOrder, testing::Values(0.1, 0.5, 1.0, 1.7, 2.0));

// Two stages on equal steps: D^g y = -y^2 + forcing with the manufactured solution y = t^5 + t^4;
// rate 3 = 2s-1 = s+1.
TEST_P(RateOfOrder, IsThatOfTheMethod) {
  const double g = GetParam();
  const auto derivative = [g](double p, double t) {
    return std::tgamma(p + 1) / std::tgamma(p + 1 - g) * std::pow(t, p - g);
  };
  const auto exact = [](double t) { return std::pow(t, 5) + std::pow(t, 4); };
  const Problem problem{.components = {{g, std::vector<double>(initial_count(g), 0.0)}},
                        .rhs = [=](double t, In y, Out f) {
                          f[0] = derivative(5, t) + derivative(4, t) + exact(t) * exact(t) - y[0] * y[0];
                        }};
  const auto error = [&](int steps) {
    const RadauRule rule(2);
    MemoryVariables memory(problem, rule, 1e-20);
    const StageEquations equations(problem, rule.nodes.cast<double>());
    const double length = problem.end / steps;
    Vec y = Vec::Zero(1);
    for (int n = 0; n < steps; ++n) {
      const auto stages = equations.solve(memory.history_term(length), {memory.weights(0, length)},
                                          n * length, length, y, Vec::Zero(1), Vec::Ones(1));
      memory.advance(length, stages.value().rhs);
      y = stages->y.bottomRows<1>().transpose();
    }
    return std::abs(y[0] - exact(1.0));
  };
  const double rate = std::log2(error(2048) / error(4096));
  EXPECT_NEAR(rate, 3.0, 0.1);
}

INSTANTIATE_TEST_SUITE_P(, RateOfOrder, testing::Values(0.3, 0.5, 0.8, 1.0, 1.3, 1.7, 2.0));

TEST(DiffusiveSolution, MeetsItsStops) {
  const auto scene = bench::scene_of("pendulum");
  const auto solution = diffusive_solution(scene.problem, {}, {1e-7, 1.0, std::numbers::pi, 20.0});
  for (const double stop : {1e-7, 1.0, std::numbers::pi, 20.0})
    EXPECT_EQ(std::ranges::count(solution.times, stop), 1) << stop;
  EXPECT_TRUE(std::ranges::is_sorted(solution.times));
}

TEST(DiffusiveSolution, NamesTheTimeOfABlowUp) {
  const Problem problem{.components = {{1.0, {4.0}}},
                        .rhs = [](double, In y, Out f) { f = y.cwiseAbs2(); }};  // 4 / (1 - 4 t)
  EXPECT_THAT([&] { diffusive_solution(problem); },
              testing::ThrowsMessage<std::runtime_error>(
                  testing::AllOf(HasSubstr("second method: "), HasSubstr("at t = 0.25"))));
}

}  // namespace
}  // namespace fde::reference
