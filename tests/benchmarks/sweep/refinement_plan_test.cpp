// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/refinement_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "fdebench/benchmarks/sweep/default_sweep.hpp"
#include "fdebench/benchmarks/sweep/forecast.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "fdebench/benchmarks/sweep/sweep_estimate.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

const RefinementPlan plan{{64, 128, 256, 512, 1024, 2048, 4096, 8192}, RefinementGoal{}};

// A refinement with errors C N^-rate and seconds s N.
Refinement refinement_of(int runs, double constant, double rate, double seconds_a_step = 1e-7) {
  Refinement refinement;
  for (int i = 0; i < runs; ++i) {
    const int steps = std::get<int>(plan.resolutions[static_cast<std::size_t>(i)]);
    const ErrorWithRate error{constant * std::pow(steps, -rate), rate};
    refinement.push_back({.steps = steps, .end = error, .maximum = error, .seconds = seconds_a_step * steps});
  }
  return refinement;
}

bool ends(const std::vector<Refinement>& of_scene) { return is_finished(plan, of_scene, of_scene.front()); }

TEST(RefinementPlans, EndAtTheFirstRunWithinTheLeastError) {
  EXPECT_FALSE(ends({refinement_of(1, 1e-4, 2.0)}));
  EXPECT_TRUE(ends({refinement_of(2, 1e-4, 2.0)}));  // 1e-4 / 128^2 = 6e-9
}

TEST(RefinementPlans, EndWhereTheErrorIsRounding) {
  auto refinement = refinement_of(3, 1.0, 1.0);
  refinement.back().maximum = {1e-9, 1.0};
  EXPECT_FALSE(ends({refinement}));
  refinement.back().end.is_stagnant = true;
  EXPECT_TRUE(ends({refinement}));
}

// The error at the end is within 1e-8 long before the maximum error, which is at the first steps.
TEST(RefinementPlans, EndWhereBothNormsHaveTheirAnswers) {
  auto refinement = refinement_of(2, 1e-4, 2.0);
  refinement.back().maximum = {1e-5, 1.0};
  EXPECT_FALSE(ends({refinement}));
  refinement.back().maximum = {1e-9, 1.0};
  EXPECT_TRUE(ends({refinement}));
}

TEST(RefinementPlans, EndBeforeARunOfMoreThanTheMostSeconds) {
  const double seconds = plan.goal->most_seconds;
  EXPECT_FALSE(ends({refinement_of(2, 10.0, 2.0, 0.9 * seconds / 256)}));
  EXPECT_TRUE(ends({refinement_of(2, 10.0, 2.0, 1.1 * seconds / 256)}));
}

// Wall time with 0.5 s to start the process and 1 ms a step: only the steps count, up to 256 of them.
TEST(RefinementPlans, DoNotCountTheStartOfAProcess) {
  auto refinement = refinement_of(2, 10.0, 2.0);
  for (RefinementRun& run : refinement) {
    run.wall_clock = true;
    run.seconds = 0.5 + 1e-3 * run.steps;
  }
  EXPECT_FALSE(ends({refinement}));
  refinement = refinement_of(3, 10.0, 2.0);
  for (RefinementRun& run : refinement) {
    run.wall_clock = true;
    run.seconds = 0.5 + 1e-3 * run.steps;
  }
  EXPECT_TRUE(ends({refinement}));  // 512 steps are forecast to take more than 0.3 s
  for (RefinementRun& run : refinement) run.wall_clock = false;
  refinement.pop_back();
  EXPECT_TRUE(ends({refinement}));
}

TEST(RefinementPlans, ForecastTheSecondsOfAStepByTheCheapestOfTheLastRuns) {
  auto refinement = refinement_of(3, 10.0, 2.0, 1e-6);
  *refinement.back().seconds *= 1e6;  // other load on the machine
  EXPECT_FALSE(ends({refinement}));
}

TEST(RefinementPlans, EndWhereMoreStepsEndInTheSameWay) {
  EXPECT_TRUE(ends({{{.steps = 64, .fails_with_more_steps = true}}}));
  EXPECT_FALSE(ends({{{.steps = 64}}})) << "a run that failed may succeed with more steps";
}

// Rate 1 from an error of 1e-2 on: at best 1e-2 / 128^1.5 = 7e-6 at the last number of steps.
TEST(RefinementPlans, EndWhereNoErrorLeftIsWithinReach) {
  EXPECT_FALSE(ends({refinement_of(4, 0.64, 1.0)})) << "a rate is not known from fewer runs";
  const auto slow = refinement_of(5, 0.64, 1.0), fast = refinement_of(5, 1.0, 2.0);
  EXPECT_TRUE(ends({slow, refinement_of(8, 1.0, 2.0)}));
  EXPECT_FALSE(ends({fast, slow})) << "of rate 2 it is";
}

TEST(RefinementPlans, EndWhereAnotherSchemeIsWithinEachErrorInLessTime) {
  const auto refinement = refinement_of(5, 0.1, 2.0);
  EXPECT_FALSE(ends({refinement, refinement_of(5, 0.1, 2.0, 0.9e-7)}))
      << "the forecast may be wrong by its margin";
  EXPECT_TRUE(ends({refinement, refinement_of(5, 0.1, 2.0, 1e-8)}));
}

// Tolerances 1e-2, 1e-4, ... with equal errors, and seconds first * 1, 10, ...
Refinement refinement_of_tolerances(int runs, double first) {
  Refinement refinement;
  for (int i = 0; i < runs; ++i) {
    const ErrorWithRate error{std::pow(10.0, -2 * (i + 1)), {}};
    refinement.push_back({.end = error, .maximum = error, .seconds = first * std::pow(10.0, i)});
  }
  return refinement;
}

TEST(RefinementPlans, OfAccuraciesEndWhereAnotherSchemeHasEveryErrorInFarLessTime) {
  const RefinementPlan accuracies{std::vector<StepsOrTolerance>(8, Tolerance{}), RefinementGoal{}};
  const auto quick = refinement_of_tolerances(4, 1e-6);
  const auto ends_beside = [&](const Refinement& refinement, const Refinement& other) {
    const std::vector<Refinement> of_scene{refinement, other};
    return is_finished(accuracies, of_scene, of_scene.front());
  };
  EXPECT_FALSE(ends_beside(refinement_of_tolerances(2, 1e-4), quick)) << "three runs are the fewest";
  EXPECT_TRUE(ends_beside(refinement_of_tolerances(3, 1e-4), quick));
  EXPECT_FALSE(ends_beside(refinement_of_tolerances(3, 1e-4), refinement_of_tolerances(3, 1e-6)))
      << "1e-8 is nobody's";
  EXPECT_FALSE(ends_beside(refinement_of_tolerances(3, 1.5e-6), quick))
      << "times may be wrong by a factor of two";
  EXPECT_FALSE(ends_beside(quick, refinement_of_tolerances(3, 1e-4)));
}

TEST(RefinementPlans, EndWhereAnotherSchemeListedBeforeIsTheSameAlgorithm) {
  const auto ended = [](const std::vector<Refinement>& refinements, std::size_t i) {
    return is_finished(plan, refinements, refinements[i]);
  };
  const auto four = refinement_of(4, 0.1, 2.0), five = refinement_of(5, 0.1, 2.0);
  EXPECT_TRUE(ended({five, five}, 1));
  EXPECT_FALSE(ended({five, five}, 0)) << "one of them goes on";
  EXPECT_FALSE(ended({four, four}, 1)) << "four equal errors may be chance";
  EXPECT_FALSE(ended({four, five}, 1)) << "the other one has ended for a reason of its own";
  auto nearly = five;
  nearly.back().end.error = std::nextafter(*nearly.back().end.error, 0.0);
  EXPECT_FALSE(ended({five, nearly}, 1));
}

TEST(RefinementPlans, WithoutAGoalEndAtTheTop) {
  const RefinementPlan all{plan.resolutions};
  const std::vector<Refinement> refinements{refinement_of(7, 1e-9, 2.0), refinement_of(8, 1e-9, 2.0)};
  EXPECT_FALSE(is_finished(all, refinements, refinements[0]));
  EXPECT_TRUE(is_finished(all, refinements, refinements[1]));
}

TEST(Runs, AreAtTheFloorOfRoundingOrOfTheReference) {
  const auto run = [](const std::map<std::string, double>& values) {
    RecordedRun recorded;
    for (const auto& [quantity, value] : values) recorded.add({.quantity = quantity, .value = value});
    return refinement_run({64}, recorded);
  };
  EXPECT_FALSE(run({{"error_end", 1e-9}, {"reference_bound", 1e-15}}).end.is_stagnant);
  EXPECT_TRUE(run({{"error_end", 1e-9}, {"reference_bound", 1e-9}}).end.is_stagnant);
  EXPECT_TRUE(run({{"error_end", 1e-9}, {"rounding_from", 3.0}}).end.is_stagnant);
  EXPECT_FALSE(run({{"error_maximum", 1e-3}, {"reference_bound", 1e-2}}).maximum.is_stagnant);
  EXPECT_TRUE(run({{"error_maximum", 1e-3}, {"reference_bound_maximum", 1e-2}}).maximum.is_stagnant);
}

// Stores the records of a sweep in memory, like a results file.
class RecordedSweep {
 public:
  explicit RecordedSweep(std::size_t most = 1'000'000) : left_(most) {}

  // Runs the sweep; fails after the number of writes given to the constructor.
  void run(const Sweep& sweep) {
    try {
      run_sweep(sweep, hooks());
    } catch (const std::runtime_error&) {
      left_ = 1'000'000;
    }
  }
  [[nodiscard]] SweepCallbacks hooks() {
    return {.recorded = [this](const RunKey& key) { return runs_[key]; },
            .append =
                [this](const std::vector<Record>& rows) {
                  if (left_-- == 0) throw std::runtime_error("killed");
                  for (const Record& row : rows) runs_[row.key].add(row);
                },
            .on_event = [](const auto&) {}};
  }
  // The numbers of steps of the runs, by scheme.
  [[nodiscard]] std::map<std::string, std::vector<int>> steps() const {
    std::map<std::string, std::vector<int>> steps;
    for (const auto& [key, run] : runs_) {
      if (run.amount() != RecordedAmount::nothing)
        steps[key.scheme].push_back(std::get<int>(key.setup.resolution));
    }
    return steps;
  }

 private:
  std::map<RunKey, RecordedRun> runs_{};
  std::size_t left_;
};

// Limits of time are disabled, so that only errors end the refinement.
Sweep sweep_of_power() {
  return {.scenes = {{&scene_maker("power")}},
          .schemes = {find_scheme("product_trapezoidal"), find_scheme("adams_pc")},
          .plan = {plan.resolutions, RefinementGoal{.errors = {1e-5}, .most_seconds = 1e9, .margin = 1e9}},
          .repeats = {.most = 1},
          .threads = 1};
}

// product_trapezoidal is within 1e-5 with 128 steps, adams_pc with 2048.
TEST(Sweeps, RefineUntilTheirGoalIsReached) {
  RecordedSweep book;
  book.run(sweep_of_power());
  EXPECT_THAT(
      book.steps(),
      testing::ElementsAre(testing::Pair("adams_pc", testing::ElementsAre(64, 128, 256, 512, 1024, 2048)),
                           testing::Pair("product_trapezoidal", testing::ElementsAre(64, 128))));
}

TEST(Sweeps, ContinuedAnywhereTakeTheRunsOfAnUninterruptedOne) {
  RecordedSweep whole;
  whole.run(sweep_of_power());
  for (std::size_t writes = 0; writes < 15; writes += 3) {
    RecordedSweep killed(writes);
    killed.run(sweep_of_power());
    EXPECT_NE(killed.steps(), whole.steps()) << writes;
    killed.run(sweep_of_power());
    EXPECT_EQ(killed.steps(), whole.steps()) << writes;
  }
}

TEST(DefaultSweeps, FollowThePlanOfAThoroughOneForAGoal) {
  EXPECT_EQ(default_plan().resolutions, thorough_plan().resolutions);
  EXPECT_TRUE(default_plan().goal);
  EXPECT_FALSE(thorough_plan().goal);
}

TEST(Forecasts, OfAFixedSweepAreItsRuns) {
  Sweep sweep = sweep_of_power();
  sweep.plan = {{16, 64, 48}};
  RecordedSweep book;
  const auto expected = forecast(sweep, book.hooks().recorded);
  book.run(sweep);
  std::map<std::string, std::vector<int>> steps;
  for (const auto& [key, seconds] : expected) {
    steps[key.scheme].push_back(std::get<int>(key.setup.resolution));
    EXPECT_GT(seconds, 0.0);
  }
  EXPECT_EQ(steps, book.steps());
  EXPECT_TRUE(forecast(sweep, book.hooks().recorded).empty()) << "nothing is left to do";
}

TEST(Forecasts, RefineAsTheSweepDoes) {
  const Sweep sweep = sweep_of_power();
  RecordedSweep book;
  const auto expected = forecast(sweep, book.hooks().recorded).size();
  EXPECT_GE(expected, 7U);
  EXPECT_LE(expected, 9U);  // the sweep makes 8 runs
}

RunKey run_with(int steps, const std::string& scheme = "l1") {
  return {.scene = {"power"}, .scheme = scheme, .setup = {.resolution = steps}};
}

TEST(Remainings, LeaveOutTheRunsOfALineThatEnds) {
  SweepEstimate remaining(
      {{run_with(64), 1.0}, {run_with(128), 2.0}, {run_with(256), 4.0}, {run_with(64, "x"), 1.0}});
  EXPECT_EQ(remaining.part_done(), 0.0);
  remaining.on_event({SweepEvent::Kind::is_done, run_with(64)});
  EXPECT_EQ(remaining.part_done(), 1.0 / 8.0);
  EXPECT_EQ(remaining.runs_expected(), 4U);
  remaining.on_event({SweepEvent::Kind::refinement_ends, run_with(64)});
  EXPECT_EQ(remaining.part_done(), 1.0 / 2.0);
  EXPECT_EQ(remaining.runs_expected(), 2U);
}

TEST(Remainings, TakeThePaceSoFar) {
  SweepEstimate remaining({{run_with(64), 990.0}, {run_with(128), 100.0}});
  EXPECT_EQ(remaining.seconds_left(0.0), 1090.0);
  remaining.on_event({SweepEvent::Kind::is_done, run_with(64)});
  EXPECT_DOUBLE_EQ(remaining.seconds_left(1990.0), 200.0);
}

}  // namespace
}  // namespace fde::bench
