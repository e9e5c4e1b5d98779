// SPDX-License-Identifier: MIT
// `fdebench solve`: its rows and columns, and its exit codes.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(Solve, PrintsAllGridTimesWithSeventeenDigits) {
  const auto answer = fdebench("solve relaxation --scheme adams_pc --steps 4");
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.out, StartsWith("t,y\n0,1\n0.25,"));
  EXPECT_EQ(csv_rows(answer.out).size(), 5U);
  const auto path = solve("adams_pc", scene_of("relaxation").problem, 4);
  EXPECT_EQ(csv_rows(answer.out)[4][1], path.y(0, 4));
  EXPECT_EQ(answer.err, "");
}

TEST(Solve, PrintsTheTimesAskedForAndTheEnergy) {
  const auto answer = fdebench("solve pendulum --scheme decoupled_multi_order --steps 8192 --until 5 --at 5");
  EXPECT_THAT(answer.out, StartsWith("t,phi,Dbeta_phi,dphi,Dalpha_phi,energy\n"));
  const auto row = csv_rows(answer.out).at(0);
  EXPECT_NEAR(row[1], 0.2609182055, 1e-9);
  EXPECT_NEAR(row[3], 0.5600178020, 1e-9);
  EXPECT_NEAR(row[5], 0.5 * row[3] * row[3] + 1.0 - std::cos(row[1]), 1e-15);
}

// Reactions are the last columns. They need adjacent steps, which are not printed, and are nan at t = 0 where
// they are unbounded.
TEST(Solve, PrintsTheReactionsBehindAllOtherColumns) {
  const std::string run = "solve fractional_constraint_2d --scheme product_trapezoidal --steps 64";
  const auto all = fdebench(run), some = fdebench(run + " --at 0,2.5,10");
  EXPECT_THAT(some.out, StartsWith("t,q1,q2,v1,v2,w1,w2,energy,constraint,lambda,power\n0,"));
  EXPECT_THAT(some.out, HasSubstr(",nan,nan\n"));
  const auto every = csv_rows(all.out), asked = csv_rows(some.out);
  ASSERT_EQ(every.size(), 65U);
  ASSERT_EQ(asked.size(), 3U);
  EXPECT_EQ(asked[1], every[16]);
  EXPECT_EQ(asked[2], every[64]);
  EXPECT_NEAR(asked[2][9], 0.83659602775236536, 0.02);
}

// lambda(10) is 0.836596027752 (mpmath).
TEST(Solve, PrintsTheReactionsOfRunsToAnAccuracy) {
  for (const std::string times : {"", " --at 10"}) {
    const auto answer =
        fdebench("solve fractional_constraint_2d --scheme radau_exponentials --accuracy 1e-7" + times);
    EXPECT_THAT(answer.out, StartsWith("t,q1,q2,v1,v2,w1,w2,energy,constraint,lambda,power\n"));
    const auto rows = csv_rows(answer.out);
    EXPECT_EQ(rows.back()[0], 10.0);
    EXPECT_NEAR(rows.back()[9], 0.836596027752, 1e-6);
    EXPECT_EQ(rows.size() > 100U, times.empty());
  }
}

TEST(Solve, TellsItsCostAsOneJsonLine) {
  const auto answer =
      fdebench("solve brusselator --scheme product_trapezoidal --steps 512 --until 5 --at 5 --cost");
  const auto cost = nlohmann::json::parse(answer.err);
  EXPECT_GT(cost["seconds"], 0.0);
  EXPECT_GT(cost["newton"], 512);
  EXPECT_EQ(cost["history"], "exponentials");
  EXPECT_DOUBLE_EQ(cost["expected_rate"], 1.8);
  EXPECT_EQ(std::ranges::count(answer.err, '\n'), 1);
}

TEST(Solve, ReportsNumericalFailureWithSchemeStepAndTime) {
  EXPECT_THAT(fdebench("solve brusselator --scheme adams_pc --steps 256"),
              is_refused(3, StartsWith("fdebench: adams_pc: not finite at step 94, t = ")));
}

TEST(Solve, DoesNotPrintAnInfiniteEnergy) {
  EXPECT_THAT(fdebench("solve damped_oscillator --scheme adams_pc --steps 60 --until 60 --set w2=1000000"),
              is_refused(3, StartsWith("fdebench: adams_pc: energy not finite at step ")));
}

// The only unknown of a relaxation is its column, so that the field equals the printed rows.
TEST(Solve, WritesTheFieldAtTheTimesThatItPrints) {
  const TemporaryFolder folder;
  const auto file = folder.file("field.csv");
  for (const std::string means : {"--scheme l1 --steps 8", "--scheme radau_exponentials --accuracy 1e-6"}) {
    const auto solve = "solve relaxation --points 3 " + means;
    auto printed = fdebench(solve).out;
    EXPECT_EQ(fdebench(fmt::format("{} --field {}", solve, file)).out, printed);
    EXPECT_EQ(content_of(file), printed.replace(0, 3, "t,u1"));
  }
  EXPECT_EQ(fdebench("solve relaxation --scheme l1 --steps 8 --field f --checkpoint c").code, 2);
}

TEST(Solve, PrintsEachKthTimeAndTheLast) {
  const std::string solve = "solve pendulum --scheme l1 --steps 10 ";
  EXPECT_EQ(fdebench(solve + "--every 4").out, fdebench(solve + "--at 0,8,16,20").out);
  EXPECT_EQ(fdebench(solve + "--every 5").out, fdebench(solve + "--at 0,10,20").out);
  EXPECT_EQ(fdebench(solve + "--every 100").out, fdebench(solve + "--at 0,20").out);
  EXPECT_EQ(fdebench(solve + "--points 3").out, fdebench(solve + "--at 0,10,20").out);
  EXPECT_EQ(fdebench(solve + "--points 1000").out, fdebench(solve).out);
  const std::string to_accuracy = "solve relaxation --scheme spectral_collocation --accuracy 1e-6 --until 2 ";
  EXPECT_EQ(fdebench(to_accuracy + "--points 5").out, fdebench(to_accuracy + "--at 0,0.5,1,1.5,2").out);
}

TEST(Solve, SaysWhatSolvesSparseEquations) {
  const auto cost = [](const std::string& scene) {
    return fdebench("solve " + scene + " --scheme l1 --steps 8 --at 1 --cost").err;
  };
  EXPECT_THAT(cost("fractional_diffusion"), HasSubstr(R"("linear_solver":"tridiagonal")"));
  EXPECT_THAT(cost("fractional_diffusion_2d"), HasSubstr(R"("linear_solver":"fast_sine")"));
  EXPECT_THAT(cost("relaxation"), Not(HasSubstr("linear_solver")));
}

TEST(Solve, PrintsTheSameWithAnyNumberOfThreads) {
  const std::string solve =
      "solve fractional_diffusion:components=40000 --scheme l1 --steps 150 --at 1 --threads ";
  EXPECT_EQ(fdebench(solve + "1").out, fdebench(solve + "4").out);
}

TEST(Solve, WarnsOfAnAccuracyThatNoDoubleHas) {
  const std::string command = "solve relaxation --scheme spectral_collocation --at 1 --accuracy ";
  EXPECT_EQ(fdebench(command + "1e-15").err, "");
  const auto answer = fdebench(command + "1e-20");
  EXPECT_EQ(answer.code, 0);
  EXPECT_EQ(answer.err, "fdebench: warning: an accuracy of 1e-20 is requested, and a double has 2.2e-16\n");
  EXPECT_EQ(fdebench(command + "1e-20 --strict").code, 3);
}

}  // namespace
}  // namespace fde::bench
