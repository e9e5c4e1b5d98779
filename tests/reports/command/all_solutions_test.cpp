// SPDX-License-Identifier: MIT
// `solve --all`: several extremals of one action with the same boundary values.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/command_line_result.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

const std::string extremals =
    "solve fractional_hamilton --set motion=given --set T=3 --scheme product_trapezoidal --steps 256";

// (q1, q2)(T/2) of two solutions, from an independent collocation code.
TEST(AllSolutions, AreThoseOfAnIndependentSearch) {
  const auto answer = fdebench(extremals + " --at 1.5 --all");
  ASSERT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, StartsWith("solution,t,q1,q2,"));
  const auto rows = csv_rows(answer.out);
  const auto has = [&](double q1, double q2) {
    return std::ranges::any_of(rows,
                               [&](const auto& row) { return std::hypot(row[2] - q1, row[3] - q2) < 2e-3; });
  };
  EXPECT_TRUE(has(0.68839, 0.41207));
  EXPECT_TRUE(has(-0.04958, 0.9597));
  for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(rows[k][0], static_cast<double>(k + 1));
}

// Without --all one of the solutions is printed.
TEST(AllSolutions, HaveTheOneThatIsPrintedAmongThem) {
  const auto one = csv_rows(fdebench(extremals + " --at 1.5").out).front();
  bool found = false;
  for (const auto& row : csv_rows(fdebench(extremals + " --at 1.5 --all").out))
    found = found || std::hypot(row[2] - one[1], row[3] - one[2]) < 1e-9;
  EXPECT_TRUE(found);
}

TEST(AllSolutions, OfALinearProblemAreOne) {
  const auto answer = fdebench("solve fractional_vakonomic --scheme grunwald_letnikov --steps 32 --all");
  const auto rows = csv_rows(answer.out);
  ASSERT_EQ(rows.size(), 33U);
  EXPECT_EQ(rows.back()[0], 1.0);
}

TEST(AllSolutions, AreAskedOfProblemsAtBothEndsOnly) {
  const auto refused = [](const std::string& words, const std::string& reason) {
    EXPECT_THAT(fdebench(words), fails_with(2, HasSubstr(reason)));
  };
  refused("solve relaxation --scheme l1 --steps 8 --all", "--all: is only taken of problems at both ends");
  refused(extremals + " --all --check", "--all: is not taken with --check");
  refused(extremals + " --all --field f.csv", "--field: is not taken with --all");
}

}  // namespace
}  // namespace fde::bench
