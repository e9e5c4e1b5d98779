// SPDX-License-Identifier: MIT
// `choose` for scenes without a reference: Robertson's equations up to 1e10, where the collocation fails
// at 1.5e7, and a constraint whose solution has nearly equal powers of t at 0, for which there is no method.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/command_line_result.hpp"

namespace fde::bench {
namespace {

using testing::ContainsRegex;

const std::string robertson = "choose robertson:until=1e10 --error 1e-3 --norm end --max-time 10";
const std::string constraint = "choose fractional_constraint_nonlinear:alpha=0.97,formulation=multiplier";

TEST(ChoiceWithoutReference, IsAnEstimateThatNamesItsTwoRuns) {
  const auto answer = printed(fdebench(robertson));
  EXPECT_THAT(answer, HasSubstr("delivers: estimated error "));
  EXPECT_THAT(answer, Not(HasSubstr(", error ")));
  EXPECT_THAT(answer, HasSubstr("\nhow sure: errors are estimated, not verified: there is no reference "
                                "(collocation: no convergence"));
  EXPECT_THAT(answer, ContainsRegex("in its place l1, graded:[0-9.]+ with N = [0-9]+ is used"));
  EXPECT_THAT(answer, ContainsRegex("which [a-z0-9_]+ with N = [0-9]+ differs from by "));
}

TEST(ChoiceWithoutReference, IsAnEstimateInJson) {
  const auto answer = fdebench(robertson + " --json");
  ASSERT_EQ(answer.code, 0) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  EXPECT_EQ(json.at("estimated"), true);
  const auto& estimate = json.at("estimate");
  EXPECT_THAT(estimate.at("missing").get<std::string>(), HasSubstr("no convergence"));
  const auto& runs = estimate.at("runs");
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_NE(runs[0].at("scheme"), runs[1].at("scheme"));
  EXPECT_EQ(runs[0].at("steps").get<int>(), 2 * runs[1].at("steps").get<int>());
  EXPECT_GE(estimate.at("error").get<double>(), 4.0 * estimate.at("difference").get<double>());
  EXPECT_LE(json.at("error").get<double>() + estimate.at("error").get<double>(), 1e-3);
}

// The difference decreases by 2 % with a doubling of the steps, so that the error is fifty times the
// difference.
TEST(ChoiceWithoutReference, IsRefusedWhereTheTwoDoNotAgree) {
  EXPECT_THAT(
      fdebench(constraint + " --error 1e-4 --max-time 3"),
      is_refused(3, AllOf(HasSubstr("there is no reference (collocation: takes no order below "),
                          ContainsRegex("and no estimate: product_trapezoidal.* and .* differ by "))));
}

// With a reference the output does not mention estimates.
TEST(ChoiceWithReference, IsNoEstimate) {
  EXPECT_THAT(fdebench("choose relaxation --error 1e-3 --max-time 5").out, Not(HasSubstr("estimate")));
  EXPECT_THAT(fdebench("choose relaxation --error 1e-3 --max-time 5 --json").out, Not(HasSubstr("estimate")));
}

}  // namespace
}  // namespace fde::bench
