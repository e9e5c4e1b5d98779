// SPDX-License-Identifier: MIT
// A time interval that begins at `start`: derivatives are from there, formulas and commands have the time t
// of users.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/command_line_result.hpp"
#include "support/message_of.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// Of x with x(start) = x0.
std::string file_from(const std::string& start, const std::string& end, const std::string& rhs,
                      const std::string& rest = "", const std::string& x0 = "1") {
  return fmt::format("start = {}\nend = {}\n[unknown.x]\norder = 0.5\nrhs = \"{}\"\ninitial = [{}]\n{}",
                     start, end, rhs, x0, rest);
}

TEST(StartInFiles, MovesAnAutonomousEquation) {
  const Scene moved = scene_of_text(file_from("2.5", "4.5", "-x + x^2/4"));
  const Scene other =
      scene_of_text("end = 2\n[unknown.x]\norder = 0.5\nrhs = \"-x + x^2/4\"\ninitial = [1]\n");
  EXPECT_EQ(moved.start, 2.5);
  EXPECT_EQ(moved.problem.end, 2.0);
  EXPECT_EQ(reference_of(moved).at(2.0).value, reference_of(other).at(2.0).value);
}

// D^0.5 (t - 1)^1.5 = Gamma(2.5) (t - 1), from t = 1.
TEST(StartInFiles, IsTheBasePointOfDerivatives) {
  for (const std::string exact : {"", "[exact]\nx = \"(t - 1)^1.5\"\n"}) {
    const Scene scene = scene_of_text(file_from("1.0", "3", "gamma(2.5)*(t - 1)", exact, "0"));
    ASSERT_TRUE(scene.reference.at);
    const auto [value, bound] = scene.reference.at(1.5);
    EXPECT_LE(std::abs(value[0] - std::pow(1.5, 1.5)), bound[0] + 1e-16) << exact;
    EXPECT_THAT(scene.smoothness.powers, ElementsAre(ElementsAre(1.5)));
  }
}

// By mpmath: e erfc(1) for D^0.5 x = -x after one unit of time.
TEST(StartInFiles, IsADecimal) {
  const TemporaryFolder folder;
  folder.write("from.toml", file_from("0.1", "1.1", "-x"));
  const auto printed = fdebench({"exact", folder.file("from.toml"), "--at", "1.1", "--digits", "30"});
  EXPECT_THAT(printed.out, HasSubstr("1.1,0.42758357615580700441075034449"));
  EXPECT_EQ(scene_of_text(file_from("0.1", "0.3", "-x")).problem.end, 0.2);
}

TEST(StartInFiles, LeavesTheTimeOfFormulas) {
  const Scene scene =
      scene_of_text(file_from("1", "3", "t^2 + step(t - 1.75)*x + mod(t, 0.8)", "[[jump]]\nat = 2.75\n"));
  EXPECT_THAT(scene.problem.jump_times,
              ElementsAre(testing::DoubleNear(0.6, 1e-15), 0.75, testing::DoubleNear(1.4, 1e-15), 1.75));
  EXPECT_NEAR(rhs_at(scene.problem, 0.5, Vec::Constant(1, 3.0))[0], 2.25 + 0.7, 1e-15);
  const Scene table = scene_of_text(
      "start = 1\nend = 2\n[table.u]\nsamples = [[1, 3], [2, 5]]\n[unknown.x]\norder = 1\nrhs = "
      "\"u(t)\"\ninitial = [0]\n");
  EXPECT_NEAR(reference_of(table).at(1.0).value[0], 4.0, 1e-14);
}

// floor(t) is 1 from the start on: that t = 1 + s is rounded to 1 for the first s makes no jump there.
TEST(StartInFiles, IsNoJumpOfAFloorThatIsWholeThere) {
  EXPECT_THAT(scene_of_text(file_from("1", "2.5", "floor(t) - x")).problem.jump_times,
              ElementsAre(testing::DoubleNear(1.0, 2.3e-16)));
  EXPECT_THAT(scene_of_text(file_from("100", "102", "mod(t, 0.8) - x")).problem.jump_times,
              ElementsAre(testing::DoubleNear(0.8, 2e-14), testing::DoubleNear(1.6, 2e-14)));
}

// x' = x(t - 1/2) from t = 1, x = t before: x = 1 + (s^2 + s)/2 at t = 1 + s, s < 1/2.
TEST(StartInFiles, LeavesTheTimeOfValuesBefore) {
  const Scene scene = scene_of_text(
      "start = 1\nend = 1.5\n[unknown.x]\norder = 1\nrhs = \"x(t - 0.5)\"\nbefore = \"t\"\ninitial = [1]\n");
  EXPECT_NEAR(reference_of(scene).at(0.5).value[0], 1.0 + (0.25 + 0.5) / 2.0, 1e-12);
}

// x' = -1 from x(2) = 1, which is 1/2 at t = 2.5.
TEST(StartInFiles, IsInWhatCommandsReadAndPrint) {
  const TemporaryFolder folder;
  const auto file = folder.file("fall.toml");
  folder.write("fall.toml",
               "start = 2\nend = 4\n[unknown.x]\norder = 1\nrhs = \"-1\"\ninitial = [1]\n"
               "[event.half]\nzero = \"x - 0.5\"\nends = true\n");
  const auto events =
      fdebench({"solve", file, "--scheme", "spectral_collocation", "--accuracy", "1e-9", "--events"});
  EXPECT_THAT(events.out, HasSubstr("half,2.5,0.5"));
  EXPECT_THAT(events.err, HasSubstr("event half ended the run at t = 2.5"));
  const auto grid =
      fdebench({"solve", file, "--scheme", "l1", "--steps", "4", "--until", "3", "--at", "2,2.25,3"});
  EXPECT_THAT(grid.out, HasSubstr("t,x\n2,1\n2.25,0.75"));
  EXPECT_THAT(grid.out, HasSubstr("\n3,"));
  EXPECT_THAT(fdebench({"exact", file, "--at", "2,3.5"}).out,
              AllOf(HasSubstr("\n2,1,"), HasSubstr("\n3.5,-0.5,")));
  EXPECT_THAT(fdebench({"choose", file, "--error", "1e-3", "--until", "3"}).out, HasSubstr("until=3"));
  EXPECT_THAT(fdebench({"scenes", file}).out, HasSubstr("end: 4, from 2"));
}

TEST(StartInFiles, IsNamedWhereATimeIsRefused) {
  const TemporaryFolder folder;
  const auto file = folder.file("fall.toml");
  folder.write("fall.toml", "start = 2\nend = 4\n[unknown.x]\norder = 1\nrhs = \"-1\"\ninitial = [1]\n");
  EXPECT_THAT(fdebench({"solve", file, "--scheme", "l1", "--steps", "4", "--at", "1"}),
              is_refused(2, HasSubstr("must be in [2, 4], the times of the run")));
  EXPECT_THAT(fdebench({"solve", file, "--scheme", "l1", "--steps", "4", "--at", "2.3"}),
              is_refused(2, HasSubstr("its neighbours are 2 and 2.5")));
  EXPECT_THAT(fdebench({"solve", file, "--scheme", "l1", "--steps", "4", "--until", "2"}),
              is_refused(2, HasSubstr("until = 2: must be above 2, the start")));
  EXPECT_THAT(fdebench({"exact", file, "--at", "1"}), is_refused(2, HasSubstr("of at least 2")));
  EXPECT_THAT(
      fdebench({"run", "--scene", file, "--scheme", "l1", "--steps", "8", "--out", folder.file("r.jsonl")}),
      is_refused(2, HasSubstr("start = 2: must be 0 for runs that are recorded")));
  EXPECT_THAT(fdebench({"plot", file, "--kind", "solution", "--out", folder.file("a.svg")}),
              is_refused(2, HasSubstr("start = 2: must be 0 for plot")));
  const auto message = [](const std::string& start, const std::string& end) {
    return message_of([&] { scene_of_text(file_from(start, end, "-x")); });
  };
  EXPECT_THAT(message("1", "1"), HasSubstr("line 2, column 7: end = 1: must be above start = 1"));
  EXPECT_THAT(message("-1", "1"),
              HasSubstr("line 1, column 9: start = -1: must be a finite number of at least 0"));
}

}  // namespace
}  // namespace fde::bench
