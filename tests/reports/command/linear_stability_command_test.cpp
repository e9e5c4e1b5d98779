// SPDX-License-Identifier: MIT
// The command fdebench stability: its rows and its error messages.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/command_output.hpp"

namespace fde::bench {
namespace {

CommandOutput stability(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "stability");
  return fdebench(arguments);
}

TEST(StabilityCommand, PrintsARowForEachScheme) {
  const auto answer = printed(stability({"--gamma", "0.5"}));
  EXPECT_THAT(answer, StartsWith("scheme,interval,angle,exact_angle,left_at_100\n"
                                 "adams_pc,1.329340388,0,135,\nl1,inf,135,135,0\n"));
  EXPECT_THAT(answer, HasSubstr("product_trapezoidal,inf,135,135,6.64e-05\n"));
}

TEST(StabilityCommand, LeavesOutWhatDoesNotTakeTheOrder) {
  EXPECT_THAT(stability({"--gamma", "0.987654321"}).out, Not(HasSubstr("commensurate")));
  EXPECT_THAT(stability({"--gamma", "0.987654321", "--scheme", "commensurate_adams_pc"}),
              fails_with(2, HasSubstr("needs orders that are multiples of one 1/M")));
}

// Backward Euler: the circle |1 - z| = 1.
TEST(StabilityCommand, PrintsTheBoundary) {
  const auto answer = stability({"--gamma", "1", "--scheme", "grunwald_letnikov", "--boundary", "2"});
  EXPECT_THAT(answer.out, StartsWith("scheme,theta,re,im\ngrunwald_letnikov,1.5707963267948966,"));
  EXPECT_EQ(std::ranges::count(answer.out, '\n'), 3);
}

TEST(StabilityCommand, NamesWhatIsWrong) {
  for (const auto* order : {"0", "2", "nan", "abc"}) {
    EXPECT_EQ(stability({"--gamma", order}).code, 2) << order;
    EXPECT_THAT(stability({"--gamma", order}).err, StartsWith("fdebench: --gamma = ")) << order;
  }
  EXPECT_THAT(stability({"--gamma", "0.5", "--boundary", "0"}).err,
              StartsWith("fdebench: --boundary = 0: must be"));
  EXPECT_EQ(stability({"--gamma", "0.5", "--scheme", "euler"}).code, 2);
  EXPECT_EQ(stability({}).code, 2);
}

}  // namespace
}  // namespace fde::bench
