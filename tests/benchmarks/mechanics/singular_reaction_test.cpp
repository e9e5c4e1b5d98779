// SPDX-License-Identifier: MIT
// A reaction like t^-alpha with a varying direction, alpha >= 1/2: fractional_constraint_nonlinear with its
// multiplier, compared with its power series.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/implicit_schemes.hpp"
#include "support/series_values.hpp"

namespace fde::bench {
namespace {

class SingularReaction : public testing::TestWithParam<std::tuple<const Scheme*, double, SeriesValue>> {};

TEST_P(SingularReaction, SchemesComeNearerToItsPowerSeries) {
  const auto& [scheme, grading, exact] = GetParam();
  const Scene scene =
      scene_of("fractional_constraint_nonlinear", {{"alpha", exact.alpha}, {"formulation", "multiplier"}});
  if (unsupported_reason(*scheme, scene.problem, Grid{exact.t, 64, grading})) GTEST_SKIP();
  std::vector<double> errors;
  for (const int steps : {64, 256, 1024}) {
    const auto path =
        scheme->solve(scene.problem, Grid{exact.t, steps, grading}, {.output_times = {exact.t}});
    ASSERT_EQ(path.status, SolveStatus::finished);
    errors.push_back(
        (columns_at(scene.outputs, exact.t, path.y.rightCols<1>()) - exact.columns).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(errors[1], errors[0] / 2.0);
  EXPECT_LT(errors[2], errors[1] / 2.0);
  EXPECT_LT(errors[2], 2e-3);
  if (scheme->id == "product_trapezoidal" && grading > 1.0) {
    EXPECT_LT(errors[2], 2e-7);
  }
}

std::string name_of_reaction(const testing::TestParamInfo<SingularReaction::ParamType>& test) {
  const auto& [scheme, grading, exact] = test.param;
  return fmt::format("{}__{}__{}", scheme->id, grading, std::lround(100.0 * exact.alpha));
}

INSTANTIATE_TEST_SUITE_P(, SingularReaction,
                         testing::Combine(testing::ValuesIn(implicit_schemes()),
                                          testing::Values(1.0, 2.0, 3.0, 4.0),
                                          testing::ValuesIn(series_values())),
                         name_of_reaction);

}  // namespace
}  // namespace fde::bench
