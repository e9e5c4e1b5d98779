#include "fdebench/benchmarks/sweep/refinement_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "fdebench/benchmarks/sweep/default_sweep.hpp"
#include "fdebench/benchmarks/sweep/forecast.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "fdebench/benchmarks/sweep/sweep_estimate.hpp"
#include "support/testing.hpp"

namespace fde {
namespace {

const RefinementPlan ladder{{64, 128, 256, 512, 1024, 2048, 4096, 8192}, RefinementGoal{}};

// A refinement with errors C N^-rate and seconds s N.
Refinement climb_of(int rungs, double constant, double rate, double seconds_a_step = 1e-7) {
  Refinement climb;
  for (int i = 0; i < rungs; ++i) {
    const int steps = std::get<int>(ladder.rungs[static_cast<std::size_t>(i)]);
    const ErrorWithRate error{constant * std::pow(steps, -rate), rate};
    climb.push_back({.steps = steps, .end = error, .maximum = error, .seconds = seconds_a_step * steps});
  }
  return climb;
}

bool ends(const std::vector<Refinement>& of_scene) { return is_finished(ladder, of_scene, of_scene.front()); }

TEST(Ladders, EndAtTheFirstRungWithinTheLeastError) {
  EXPECT_FALSE(ends({climb_of(1, 1e-4, 2.0)}));
  EXPECT_TRUE(ends({climb_of(2, 1e-4, 2.0)}));  // 1e-4 / 128^2 = 6e-9
}

TEST(Ladders, EndWhereTheErrorIsRounding) {
  auto climb = climb_of(3, 1.0, 1.0);
  climb.back().maximum = {1e-9, 1.0};
  EXPECT_FALSE(ends({climb}));
  climb.back().end.at_floor = true;
  EXPECT_TRUE(ends({climb}));
}

// The error at the end is within 1e-8 long before the maximum error, which is at the first steps.
TEST(Ladders, EndWhereBothNormsHaveTheirAnswers) {
  auto climb = climb_of(2, 1e-4, 2.0);
  climb.back().maximum = {1e-5, 1.0};
  EXPECT_FALSE(ends({climb}));
  climb.back().maximum = {1e-9, 1.0};
  EXPECT_TRUE(ends({climb}));
}

TEST(Ladders, EndBeforeARungOfMoreThanTheMostSeconds) {
  const double seconds = ladder.goal->most_seconds;
  EXPECT_FALSE(ends({climb_of(2, 10.0, 2.0, 0.9 * seconds / 256)}));
  EXPECT_TRUE(ends({climb_of(2, 10.0, 2.0, 1.1 * seconds / 256)}));
}

// Wall time with 0.5 s to start the process and 1 ms a step: only the steps count, up to 256 of them.
TEST(Ladders, DoNotCountTheStartOfAProcess) {
  auto climb = climb_of(2, 10.0, 2.0);
  for (RefinementRun& rung : climb) {
    rung.wall_clock = true;
    rung.seconds = 0.5 + 1e-3 * rung.steps;
  }
  EXPECT_FALSE(ends({climb}));
  climb = climb_of(3, 10.0, 2.0);
  for (RefinementRun& rung : climb) {
    rung.wall_clock = true;
    rung.seconds = 0.5 + 1e-3 * rung.steps;
  }
  EXPECT_TRUE(ends({climb}));  // 512 steps are forecast to take more than 0.3 s
  for (RefinementRun& rung : climb) rung.wall_clock = false;
  climb.pop_back();
  EXPECT_TRUE(ends({climb}));
}

TEST(Ladders, ForecastTheSecondsOfAStepByTheCheapestOfTheLastRungs) {
  auto climb = climb_of(3, 10.0, 2.0, 1e-6);
  *climb.back().seconds *= 1e6;  // other load on the machine
  EXPECT_FALSE(ends({climb}));
}

TEST(Ladders, EndWhereMoreStepsEndInTheSameWay) {
  EXPECT_TRUE(ends({{{.steps = 64, .hopeless = true}}}));
  EXPECT_FALSE(ends({{{.steps = 64}}})) << "a run that failed may succeed with more steps";
}

// Rate 1 from an error of 1e-2 on: at best 1e-2 / 128^1.5 = 7e-6 at the last number of steps.
TEST(Ladders, EndWhereNoErrorLeftIsWithinReach) {
  EXPECT_FALSE(ends({climb_of(4, 0.64, 1.0)})) << "a rate is not known from fewer rungs";
  const auto slow = climb_of(5, 0.64, 1.0), fast = climb_of(5, 1.0, 2.0);
  EXPECT_TRUE(ends({slow, climb_of(8, 1.0, 2.0)}));
  EXPECT_FALSE(ends({fast, slow})) << "of rate 2 it is";
}

TEST(Ladders, EndWhereAnotherSchemeIsWithinEachErrorInLessTime) {
  const auto climb = climb_of(5, 0.1, 2.0);
  EXPECT_FALSE(ends({climb, climb_of(5, 0.1, 2.0, 0.9e-7)})) << "the forecast may be wrong by its margin";
  EXPECT_TRUE(ends({climb, climb_of(5, 0.1, 2.0, 1e-8)}));
}

// Tolerances 1e-2, 1e-4, ... with equal errors, and seconds first * 1, 10, ...
Refinement climb_of_accuracies(int rungs, double first) {
  Refinement climb;
  for (int i = 0; i < rungs; ++i) {
    const ErrorWithRate error{std::pow(10.0, -2 * (i + 1)), {}};
    climb.push_back({.end = error, .maximum = error, .seconds = first * std::pow(10.0, i)});
  }
  return climb;
}

TEST(Ladders, OfAccuraciesEndWhereAnotherSchemeHasEveryErrorInFarLessTime) {
  const RefinementPlan accuracies{std::vector<StepsOrTolerance>(8, Tolerance{}), RefinementGoal{}};
  const auto quick = climb_of_accuracies(4, 1e-6);
  const auto ends_beside = [&](const Refinement& climb, const Refinement& other) {
    const std::vector<Refinement> of_scene{climb, other};
    return is_finished(accuracies, of_scene, of_scene.front());
  };
  EXPECT_FALSE(ends_beside(climb_of_accuracies(2, 1e-4), quick)) << "three rungs are the fewest";
  EXPECT_TRUE(ends_beside(climb_of_accuracies(3, 1e-4), quick));
  EXPECT_FALSE(ends_beside(climb_of_accuracies(3, 1e-4), climb_of_accuracies(3, 1e-6))) << "1e-8 is nobody's";
  EXPECT_FALSE(ends_beside(climb_of_accuracies(3, 1.5e-6), quick)) << "times may be wrong by a factor of two";
  EXPECT_FALSE(ends_beside(quick, climb_of_accuracies(3, 1e-4)));
}

TEST(Ladders, EndWhereAnotherSchemeListedBeforeIsTheSameAlgorithm) {
  const auto ended = [](const std::vector<Refinement>& climbs, std::size_t i) {
    return is_finished(ladder, climbs, climbs[i]);
  };
  const auto four = climb_of(4, 0.1, 2.0), five = climb_of(5, 0.1, 2.0);
  EXPECT_TRUE(ended({five, five}, 1));
  EXPECT_FALSE(ended({five, five}, 0)) << "one of them goes on";
  EXPECT_FALSE(ended({four, four}, 1)) << "four equal errors may be chance";
  EXPECT_FALSE(ended({four, five}, 1)) << "the other one has ended for a reason of its own";
  auto nearly = five;
  nearly.back().end.error = std::nextafter(*nearly.back().end.error, 0.0);
  EXPECT_FALSE(ended({five, nearly}, 1));
}

TEST(Ladders, WithoutAGoalEndAtTheTop) {
  const RefinementPlan all{ladder.rungs};
  const std::vector<Refinement> climbs{climb_of(7, 1e-9, 2.0), climb_of(8, 1e-9, 2.0)};
  EXPECT_FALSE(is_finished(all, climbs, climbs[0]));
  EXPECT_TRUE(is_finished(all, climbs, climbs[1]));
}

TEST(Rungs, AreAtTheFloorOfRoundingOrOfTheReference) {
  const auto rung = [](const std::map<std::string, double>& values) {
    RecordedRun run;
    for (const auto& [quantity, value] : values) run.note({.quantity = quantity, .value = value});
    return refinement_run({64}, run);
  };
  EXPECT_FALSE(rung({{"error_end", 1e-9}, {"reference_bound", 1e-15}}).end.at_floor);
  EXPECT_TRUE(rung({{"error_end", 1e-9}, {"reference_bound", 1e-9}}).end.at_floor);
  EXPECT_TRUE(rung({{"error_end", 1e-9}, {"rounding_from", 3.0}}).end.at_floor);
  EXPECT_FALSE(rung({{"error_maximum", 1e-3}, {"reference_bound", 1e-2}}).maximum.at_floor);
  EXPECT_TRUE(rung({{"error_maximum", 1e-3}, {"reference_bound_maximum", 1e-2}}).maximum.at_floor);
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
                  for (const Record& row : rows) runs_[row.key].note(row);
                },
            .tell = [](const auto&) {}};
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
          .ladder = {ladder.rungs, RefinementGoal{.errors = {1e-5}, .most_seconds = 1e9, .margin = 1e9}},
          .repeats = {.most = 1},
          .threads = 1};
}

// product_trapezoidal is within 1e-5 with 128 steps, adams_pc with 2048.
TEST(Sweeps, ClimbUntilTheirGoalIsReached) {
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

TEST(DefaultSweeps, ClimbTheLadderOfAThoroughOneForAGoal) {
  EXPECT_EQ(default_plan().rungs, thorough_plan().rungs);
  EXPECT_TRUE(default_plan().goal);
  EXPECT_FALSE(thorough_plan().goal);
}

TEST(Forecasts, OfAFixedSweepAreItsRuns) {
  Sweep sweep = sweep_of_power();
  sweep.ladder = {{16, 64, 48}};
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

TEST(Forecasts, ClimbAsTheSweepDoes) {
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
  remaining.hear({SweepEvent::Kind::is_done, run_with(64)});
  EXPECT_EQ(remaining.part_done(), 1.0 / 8.0);
  EXPECT_EQ(remaining.runs_expected(), 4U);
  remaining.hear({SweepEvent::Kind::refinement_ends, run_with(64)});
  EXPECT_EQ(remaining.part_done(), 1.0 / 2.0);
  EXPECT_EQ(remaining.runs_expected(), 2U);
}

TEST(Remainings, TakeThePaceSoFar) {
  SweepEstimate remaining({{run_with(64), 990.0}, {run_with(128), 100.0}});
  EXPECT_EQ(remaining.seconds_left(0.0), 1090.0);
  remaining.hear({SweepEvent::Kind::is_done, run_with(64)});
  EXPECT_DOUBLE_EQ(remaining.seconds_left(1990.0), 200.0);
}

}  // namespace
}  // namespace fde
