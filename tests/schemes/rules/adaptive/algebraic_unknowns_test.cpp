// SPDX-License-Identifier: MIT
// Unknowns that only an algebraic row determines are as accurate as the others.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/adaptive_schemes.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

class AlgebraicUnknown : public testing::TestWithParam<const Scheme*> {
 protected:
  void SetUp() override {
    if (!GetParam()->capabilities.algebraic_rows) GTEST_SKIP() << "takes no algebraic rows";
  }
  static const std::vector<double>& times() {
    static const std::vector<double> all{0.02, 0.3, 0.77, 1.0, 1.9, 2.0};
    return all;
  }
};

// Abel's equation of the first kind I^g u = t^p, as D^g w = u, 0 = w - t^p: u = Gamma(p+1)/Gamma(p+1-g)
// t^(p-g).
TEST_P(AlgebraicUnknown, SolvesAbelsEquation) {
  for (const auto& [order, power] : {std::pair{0.3, 1.0}, {0.5, 1.0}, {0.7, 1.5}, {0.9, 2.5}, {1.0, 1.7}}) {
    const Problem problem{.components = {{order, {0.0}}, {0.0, {0.0}}},
                          .rhs = [p = power](double t, In y, Out f) { f << y[1], y[0] - std::pow(t, p); },
                          .end = 2.0};
    for (const double accuracy : {1e-4, 1e-7}) {
      const auto path = GetParam()->solve(problem, Tolerance{accuracy, accuracy}, {.output_times = times()});
      ASSERT_EQ(path.status, SolveStatus::finished) << order;
      for (std::size_t i = 0; i < times().size(); ++i) {
        const double u =
            std::tgamma(power + 1.0) / std::tgamma(power + 1.0 - order) * std::pow(times()[i], power - order);
        EXPECT_NEAR(path.y(1, static_cast<Eigen::Index>(i)), u, 5.0 * accuracy * (1.0 + u))
            << "order " << order << ", accuracy " << accuracy << ", t = " << times()[i];
      }
    }
  }
}

// u = 300 (w - z) with D^0.5 w = -w and z' = -z: the errors of w and z are magnified.
TEST_P(AlgebraicUnknown, IsAsAccurateWhereItMagnifiesErrors) {
  const Problem problem{.components = {{0.5, {1.0}}, {1.0, {1.0}}, {0.0, {0.0}}},
                        .rhs = [](double, In y, Out f) { f << -y[0], -y[1], y[2] - 300.0 * (y[0] - y[1]); },
                        .end = 2.0};
  const double accuracy = 1e-5;
  const auto path = GetParam()->solve(problem, Tolerance{accuracy, accuracy}, {.output_times = times()});
  ASSERT_EQ(path.status, SolveStatus::finished);
  for (std::size_t i = 0; i < times().size(); ++i) {
    const double t = times()[i];
    const double u = 300.0 * (reference::mittag_leffler(0.5, 1.0, -std::sqrt(t)) - std::exp(-t));
    EXPECT_NEAR(path.y(2, static_cast<Eigen::Index>(i)), u, 10.0 * accuracy * (1.0 + std::abs(u))) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, AlgebraicUnknown, testing::ValuesIn(adaptive_schemes()), id_of_param);

}  // namespace
}  // namespace fde::bench
