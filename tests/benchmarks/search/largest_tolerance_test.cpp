// SPDX-License-Identifier: MIT
// largest_tolerance() with errors that are given functions of the tolerance.

#include "fdebench/benchmarks/search/largest_tolerance.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace fde::bench {
namespace {

constexpr double wanted = 1e-6;

std::optional<CandidateRun> found_for(const std::function<double(double asked)>& delivered) {
  return largest_tolerance(wanted, [&](double asked) {
    const double error = delivered(asked);
    return CandidateRun{.requested_tolerance = asked, .error = error, .meets_accuracy = error <= wanted};
  });
}

TEST(LoosestAccuracy, IsWithinAFactorOfTwoOfTheLoosest) {
  for (const double ratio : {1e-4, 0.02, 0.5, 1.0, 3.0, 70.0, 2e4}) {
    const auto found = found_for([=](double asked) { return ratio * asked; });
    ASSERT_TRUE(found) << ratio;
    EXPECT_TRUE(found->meets_accuracy) << ratio;
    EXPECT_GT(2.0 * ratio * *found->requested_tolerance, wanted) << ratio;
  }
}

TEST(LoosestAccuracy, IsATenthAtMost) {
  const auto found = found_for([](double) { return 0.0; });
  EXPECT_LE(*found->requested_tolerance, 0.1);
  EXPECT_GT(*found->requested_tolerance, 0.009);
}

TEST(LoosestAccuracy, IsNoneWhereErrorsDoNotFall) {
  EXPECT_FALSE(found_for([](double) { return 2.0 * wanted; }));
}

TEST(LoosestAccuracy, IsGivenUpWhereTimeRunsOut) {
  int attempts = 0;
  const auto found = largest_tolerance(wanted, [&](double asked) {
    ++attempts;
    return CandidateRun{.requested_tolerance = asked, .ending = {.kind = SolveStatus::out_of_budget}};
  });
  EXPECT_FALSE(found);
  EXPECT_EQ(attempts, 1);
}

}  // namespace
}  // namespace fde::bench
