// SPDX-License-Identifier: MIT
// Equations with jumps and kinks: functions of the unknowns make them nonlinear, functions of t give jumps at
// known times. The reference of an equation file is checked against schemes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using testing::DoubleEq;

std::vector<double> jumps_of(const std::string& rhs, double end) {
  Scene scene = scene_of_text(relaxation_file(rhs));
  set_end(scene, end);
  return scene.problem.jump_times;
}

// The derivatives of all of these are constant wherever they exist.
TEST(Piecewise, FunctionsOfUnknownsAreNotLinear) {
  for (const auto* rhs : {"1 + step(x - 1)", "-sign(x)", "-x - sign(2*x - t)", "step(step(x))"})
    EXPECT_FALSE(is_linear(scene_of_text(relaxation_file(rhs)).problem)) << rhs;
  for (const auto* rhs : {"abs(x)", "min(x, 1)", "max(x, t) - x"})
    EXPECT_FALSE(is_linear(scene_of_text(relaxation_file(rhs)).problem)) << rhs;
}

TEST(Piecewise, LoadsLeaveAnEquationLinear) {
  for (const auto* rhs : {"step(t - 0.5) - x", "min(t, 1) - 2*x", "abs(sin(t)) + x", "sign(cos(t)) - x"})
    EXPECT_TRUE(is_linear(scene_of_text(relaxation_file(rhs)).problem)) << rhs;
}

TEST(JumpsInTime, AreFoundWhereSignsAndStepsChange) {
  EXPECT_THAT(jumps_of("step(t - 0.25) - x", 1.0), ElementsAre(0.25));
  EXPECT_THAT(jumps_of("sign(3*t - 1) + step(t - 0.5)*sin(x)", 1.0), ElementsAre(DoubleEq(1.0 / 3.0), 0.5));
  EXPECT_THAT(jumps_of("step(max(t - 0.5, 0)) - x", 1.0), ElementsAre(DoubleEq(0.5)));
  const double third = std::numbers::pi / 3.0;
  EXPECT_THAT(jumps_of("sign(sin(3*t)) - x", 4.0),
              ElementsAre(DoubleEq(third), DoubleEq(2.0 * third), DoubleEq(3.0 * third)));
}

TEST(JumpsInTime, AreNoneWhereASignTouchesZeroOrDependsOnAnUnknown) {
  EXPECT_THAT(jumps_of("abs(t - 0.5) - x", 1.0), ElementsAre());
  EXPECT_THAT(jumps_of("step(x - t)", 1.0), ElementsAre());
  EXPECT_THAT(jumps_of("sign(exp(t)) + step(log(t + 3) - 9) - x", 1.0), ElementsAre());
}

TEST(JumpsInTime, AreThoseUpToTheEnd) {
  EXPECT_THAT(jumps_of("step(t - 3) - x", 2.0), ElementsAre());
  EXPECT_THAT(jumps_of("step(t - 3) - x", 4.0), ElementsAre(3.0));
  EXPECT_THAT(jumps_of("step(t - 3e-9) - x", 1.0), ElementsAre(3e-9));
  EXPECT_THAT(jumps_of("sign(t) + step(sin(t)) - x", 1.0), ElementsAre());
}

TEST(JumpsInTime, ThatAFileDeclaresAreTheSame) {
  const std::string file = relaxation_file("step(t - 0.5)*cos(x) - x");
  const Scene declared = scene_of_text(file + "[[jump]]\nat = 0.5\n");
  EXPECT_THAT(declared.problem.jump_times, ElementsAre(0.5));
  const double found = reference_of(scene_of_text(file)).at(1.0).value[0];
  EXPECT_EQ(found, reference_of(declared).at(1.0).value[0]);
}

// D^0.5 x = 1 + step(x - 1), x(0) = 0, reaches 1 at t = pi/4, and x = 2 sqrt(t/pi) + 2 sqrt((t - pi/4)/pi)
// after that.
TEST(KnownSolutions, AreNotThoseOfASwitchThatStaysAtItsStart) {
  const std::string file = relaxation_file("1 + step(x - 1)");
  Scene scene = scene_of_text(file.substr(0, file.rfind("[1]")) + "[0]\n");
  set_end(scene, 2.0);
  const double exact = 2.0 * std::sqrt(2.0 / std::numbers::pi) +
                       2.0 * std::sqrt((2.0 - std::numbers::pi / 4.0) / std::numbers::pi);
  try {
    const reference::ReferenceValue known = reference_of(scene).at(2.0);
    EXPECT_LE(std::abs(known.value[0] - exact), known.bound[0]);
  } catch (const std::runtime_error& none) {
    EXPECT_THAT(none.what(), HasSubstr("t = "));
  }
}

// D^0.5 x = -x, x(0) = 1 is not solved by 1 - t, which the file claims.
TEST(KnownSolutions, AreNotBelievedAgainstTwoSchemes) {
  const TemporaryFolder folder;
  const std::string file = folder.file("false.toml");
  folder.write("false.toml", relaxation_file("-x") + "[exact]\nx = \"1 - t\"\n");
  EXPECT_THAT(
      fdebench({"exact", file, "--at", "0.5,1"}),
      is_refused(3, AllOf(HasSubstr("what is known of x at t = "), HasSubstr("is not believed: it says "))));
  EXPECT_EQ(fdebench({"exact", file, "--at", "0.5,1", "--digits", "30"}).code, 3);
}

}  // namespace
}  // namespace fde::bench
