// SPDX-License-Identifier: MIT
// fdebench choose: its statements are checked by running the recommended command.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(Choose, MakesTheRunThatItNames) {
  const auto json =
      nlohmann::json::parse(printed(fdebench("choose power --set p=1.83 --error 1e-4 --json --max-time 5")));
  EXPECT_LE(json["error"], 1e-4);
  EXPECT_LE(json["seconds_low"], json["seconds"]);
  EXPECT_GE(json["seconds_high"], json["seconds"]);
  const std::string command = json["command"];
  const auto again = printed(fdebench(command.substr(command.find(' ') + 1)));
  double worst = 0.0;
  for (const auto& row : csv_rows(again)) {
    const double exact = std::pow(row[0], 1.83);
    worst = std::max(worst, std::abs(row[1] - exact) / (1.0 + exact));
  }
  // With adaptive step size the error is measured between the printed steps too.
  EXPECT_LE(worst, (1.0 + 1e-6) * json["error"].get<double>());
  if (json["asked"].is_null()) {
    EXPECT_NEAR(worst / json["error"].get<double>(), 1.0, 1e-6);
  }
}

TEST(Choose, SaysWhatWouldBeNeeded) {
  EXPECT_THAT(fdebench("choose fractional_diffusion --error 1e-12 --max-time 0.3"),
              is_refused(3, HasSubstr("would need about N = ")));
}

// The damper answers a pulse of 200 N with a few millimetres: an absolute error of 1e-2 is larger than the
// answer.
TEST(Choose, SaysThatAnAccuracyIsCoarseForItsColumn) {
  const TemporaryFolder folder;
  folder.write("damper.toml",
               "end = 0.05\n[unknown.x]\nterms = [[0.25, 2], [40, 0.6]]\n"
               "rhs = \"200*t*exp(-300*t) - 1e4*x\"\ninitial = [0.0, 0.0]\n");
  const auto command = "choose " + folder.file("damper.toml") + " --columns x --max-time 10 --error 1e-2";
  const auto coarse = fdebench(command);
  EXPECT_THAT(coarse.out, HasSubstr("\ncoarse: the error allowed is in x 1.0e-2, "));
  EXPECT_THAT(coarse.out, HasSubstr(" times its largest value "));
  const auto peak = nlohmann::json::parse(fdebench(command + " --scale peak --json").out);
  EXPECT_FALSE(peak.contains("coarse"));
  EXPECT_EQ(peak["scale"], "peak");
  const auto largest =
      nlohmann::json::parse(fdebench(command + " --json").out)["coarse"][0]["largest"].get<double>();
  const std::string solve = peak["command"];
  const auto rows = csv_rows(fdebench(solve.substr(solve.find(' ') + 1)).out);
  std::string times;
  for (std::size_t i = 1; i < rows.size(); ++i) times += fmt::format("{}{}", i > 1 ? "," : "", rows[i][0]);
  const auto exact = csv_rows(fdebench("exact " + folder.file("damper.toml") + " --at " + times).out);
  ASSERT_EQ(exact.size() + 1, rows.size());
  double worst = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    worst = std::max(worst, std::abs(rows[i][1] - exact[i - 1][1]));
  EXPECT_LT(worst, 1.01e-2 * largest) << "a hundredth of the largest value";
}

// dphi has a term t^(1/2) near 0, phi has none: errors of phi are smaller.
TEST(Choose, CountsTheColumnsThatAreNamed) {
  const auto chosen = nlohmann::json::parse(
      fdebench("choose pendulum --until 2 --error 1e-4 --scale absolute --columns phi --max-time 5 --json")
          .out);
  EXPECT_EQ(chosen["columns"], std::vector<std::string>{"phi"});
  Scene scene = scene_of("pendulum");
  scene.problem.end = 2.0;
  const double asked = chosen["asked"];
  const auto path =
      find_scheme(chosen["scheme"].get<std::string>())
          ->solve(scene.problem, Tolerance{asked, asked}, {.output_times = comparison_times(scene.problem)});
  EXPECT_EQ(path.steps, chosen["steps"]);
  EXPECT_TRUE(chosen["grid"].is_null());
  const Rows errors = columns_of(scene.outputs, path) - MemoizedReference(scene).at(path.times);
  const double largest = errors.row(0).cwiseAbs().maxCoeff();
  EXPECT_LE(largest, 1e-4);
  EXPECT_NEAR(chosen["error"], largest, 1e-3 * largest);
}

}  // namespace
}  // namespace fde::bench
