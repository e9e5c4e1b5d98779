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

// Explicit Euler's method with lag 1: y_n = y_(n-1) + z y_(n-1), and D y = b y(t - 1) ends at pi/2.
TEST(StabilityCommand, PrintsIntervalsWithADelay) {
  const auto answer = stability({"--gamma", "1", "--delay", "1"});
  EXPECT_THAT(answer.out, StartsWith("scheme,interval,exact_interval\n"));
  EXPECT_THAT(answer.out, HasSubstr("grunwald_letnikov,2,1.570796327\n"));
  EXPECT_THAT(answer.out, Not(HasSubstr("multi_term")));
  EXPECT_THAT(answer.out, Not(HasSubstr("bdf2")));
  const auto boundary = stability({"--gamma", "1", "--scheme", "l1", "--boundary", "1", "--delay", "2"});
  EXPECT_THAT(boundary.out, HasSubstr("l1,3.1415926535897931,2,"));
}

TEST(StabilityCommand, NamesWhatIsWrong) {
  for (const auto* order : {"0", "2", "nan", "abc"}) {
    EXPECT_EQ(stability({"--gamma", order}).code, 2) << order;
    EXPECT_THAT(stability({"--gamma", order}).err, StartsWith("fdebench: --gamma = ")) << order;
  }
  EXPECT_THAT(stability({"--gamma", "0.5", "--boundary", "0"}).err,
              StartsWith("fdebench: --boundary = 0: must be"));
  for (const auto* delay : {"0", "-1", "1.5", "10001", "x"}) {
    EXPECT_THAT(stability({"--gamma", "0.5", "--delay", delay}),
                fails_with(2, StartsWith("fdebench: --delay = " + std::string(delay) + ": must be")));
  }
  EXPECT_THAT(stability({"--gamma", "0.5", "--delay", "2", "--scheme", "bdf6"}),
              fails_with(2, HasSubstr("steps in the shortest delay")));
  EXPECT_THAT(stability({"--gamma", "0.5", "--delay", "2", "--scheme", "multi_term_pc"}),
              fails_with(2, HasSubstr("takes no delays")));
  EXPECT_EQ(stability({"--gamma", "0.5", "--scheme", "euler"}).code, 2);
  EXPECT_EQ(stability({}).code, 2);
}

}  // namespace
}  // namespace fde::bench
