// SPDX-License-Identifier: MIT
// --grid graded:auto of solve and run.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/sweep/default_sweep.hpp"
#include "fdebench/benchmarks/sweep/scene_refinements.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(OptimalGrid, SolveIsThatOfTheGradingAndNamesIt) {
  const auto chosen = fdebench("solve relaxation --scheme l1 --steps 300 --at 1 --grid graded:auto --cost");
  const auto named = fdebench("solve relaxation --scheme l1 --steps 300 --at 1 --grid graded:3");
  EXPECT_EQ(chosen.code, 0);
  EXPECT_EQ(chosen.out, named.out);
  EXPECT_NE(chosen.err.find(R"("grid":"graded:3")"), std::string::npos) << chosen.err;
}

TEST(OptimalGrid, ResultsNameTheGradingOfEachScheme) {
  const TemporaryFolder folder;
  const auto file = folder.file("r.jsonl");
  expect_success(
      fdebench("run --scene relaxation --scheme l1 --scheme product_trapezoidal --scheme "
               "grunwald_letnikov --steps 64 --repeat 1 --grid graded:auto --out " +
               file));
  std::set<double> gradings;
  for (const Record& run : read_results(file).records) {
    EXPECT_EQ(run.ending.kind, SolveStatus::finished);
    gradings.insert(run.key.settings.grading);
  }
  EXPECT_EQ(gradings, (std::set{1.0, 2.0, 3.0}));
}

// A scheme of Sweep::graded runs on two grids if every order is fractional; on one for a multi-term chain, a
// row of integer order, or another scheme.
TEST(OptimalGrid, OfASweepIsBesideTheUniformOne) {
  Sweep sweep;
  sweep.graded = graded_schemes();
  const auto gradings = [&](const char* scheme, const char* scene) {
    std::vector<double> found;
    const Scene target = scene_of(scene);
    for (const auto& settings : settings_of(sweep, *find_scheme(scheme), &target.problem))
      found.push_back(settings.grading);
    return found;
  };
  EXPECT_EQ(gradings("l1", "relaxation"), (std::vector{1.0, 3.0}));
  EXPECT_EQ(gradings("l1_2", "relaxation"), (std::vector{1.0, 5.0}));
  EXPECT_EQ(gradings("l2_1_sigma", "relaxation"), (std::vector{1.0, 4.0}));
  EXPECT_EQ(gradings("product_trapezoidal", "relaxation"), (std::vector{1.0, 2.0}));
  EXPECT_EQ(gradings("adams_pc", "relaxation"), std::vector{1.0});
  EXPECT_EQ(gradings("l1", "pendulum"), std::vector{1.0});
  EXPECT_EQ(gradings("l1", "knife_edge"), std::vector{1.0});
}

TEST(OptimalGrid, BadGridsAreOneLine) {
  for (const auto* grid :
       {"graded:best", "graded:", "graded:0.5", "graded:101", "graded:nan", "graded:autox"}) {
    EXPECT_THAT(
        fdebench(std::string("solve relaxation --scheme l1 --steps 8 --grid ") + grid),
        fails_with(2, fmt::format("fdebench: --grid = {}: must be uniform or graded:R with R in [1, 100], or "
                                  "graded:auto\n",
                                  grid)));
  }
  const auto beside = fdebench("run --scene relaxation --external a=b --steps 8 --grid graded:auto --out x");
  EXPECT_EQ(beside.code, 2);
  EXPECT_NE(beside.err.find("--grid = graded:auto: must be uniform or graded:R beside --external"),
            std::string::npos)
      << beside.err;
}

}  // namespace
}  // namespace fde::bench
