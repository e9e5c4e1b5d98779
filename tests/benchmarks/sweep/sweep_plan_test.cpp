// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sweep_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "fdebench/benchmarks/records/default_accuracies.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/search/accuracy_target.hpp"
#include "fdebench/benchmarks/sweep/default_sweep.hpp"
#include "fdebench/benchmarks/sweep/forecast.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "fdebench/benchmarks/sweep/sweep_estimate.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(Runs, AreAtTheFloorOfRoundingOrOfTheReference) {
  const auto run = [](const std::map<std::string, double>& values) {
    Record recorded{.key = {.settings = {64}}};
    for (const auto& [quantity, value] : values) {
      recorded.values.set(quantity, value);
      if (quantity.starts_with("error_")) recorded.values.set(quantity + "_mixed", value);
    }
    return refinement_run(recorded);
  };
  const auto stagnates = [&](std::size_t kind, const std::map<std::string, double>& values) {
    return run(values).errors[kind].is_stagnant;
  };
  EXPECT_FALSE(stagnates(error_at_end, {{"error_end", 1e-9}, {"reference_bound", 1e-15}}));
  EXPECT_TRUE(stagnates(error_at_end, {{"error_end", 1e-9}, {"reference_bound", 1e-9}}));
  EXPECT_TRUE(stagnates(error_at_end, {{"error_end", 1e-9}, {"rounding_from", 3.0}}));
  EXPECT_FALSE(stagnates(error_maximum, {{"error_maximum", 1e-3}, {"reference_bound", 1e-2}}));
  EXPECT_TRUE(stagnates(error_maximum, {{"error_maximum", 1e-3}, {"reference_bound_maximum", 1e-2}}));
  EXPECT_EQ(run({{"error_end", 1e-9}, {"reference_bound", 1e-9}}).errors[error_at_end].value, 2e-9);
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
    const auto append = [this](const Record& run) {
      if (left_-- == 0) throw std::runtime_error("killed");
      runs_[run.key] = run;
    };
    const auto recorded = [this](const RunKey& key) {
      const auto found = runs_.find(key);
      return found == runs_.end() ? std::nullopt : std::optional(found->second);
    };
    return {.recorded = recorded, .append = append, .append_times = append, .on_event = [](const auto&) {}};
  }
  // The numbers of steps of the runs, by scheme.
  [[nodiscard]] std::map<std::string, std::vector<int>> steps() const {
    std::map<std::string, std::vector<int>> steps;
    for (const auto& [key, run] : runs_) {
      steps[key.scheme].push_back(std::get<int>(key.settings.resolution));
    }
    return steps;
  }

 private:
  std::map<RunKey, Record> runs_{};
  std::size_t left_;
};

// Limits of time are disabled, so that only errors end the refinement.
Sweep sweep_of_power() {
  return {.scenes = {{&scene_factory("power")}},
          .schemes = {find_scheme("product_trapezoidal"), find_scheme("adams_pc")},
          .plan = {.goal = SearchGoal{.targets = {{error_maximum, 1e-5}},
                                      .coarsest_steps = 64,
                                      .most_seconds = 1e9,
                                      .margin = 1e9,
                                      .closeness = 2.01}},
          .repeats = {.most = 1},
          .threads = 1};
}

// product_trapezoidal is within 1e-5 with 128 steps, adams_pc with 1024 on the mixed scale.
TEST(Sweeps, RefineUntilTheirGoalIsReached) {
  RecordedSweep book;
  book.run(sweep_of_power());
  const auto steps = book.steps();
  EXPECT_THAT(steps.at("product_trapezoidal"), ElementsAre(64, 128));
  EXPECT_THAT(steps.at("adams_pc"), ElementsAre(64, 128, 256, 512, 1024));
}

// The delay is 1/20 of the interval. The multi-term scheme takes no delay with any number of steps.
TEST(Sweeps, RefineUntilASchemeTakesTheDelay) {
  Sweep sweep = sweep_of_power();
  sweep.scenes = {{&scene_factory("delayed_logistic")}};
  sweep.schemes = {find_scheme("adams_pc"), find_scheme("multi_term_pc")};
  sweep.plan.goal->targets = {{error_at_end, 1e-2}};
  sweep.plan.goal->coarsest_steps = 4;
  RecordedSweep book;
  book.run(sweep);
  const auto steps = book.steps();
  EXPECT_THAT(steps.at("adams_pc"), ElementsAre(4, 8, 16, 32));
  EXPECT_THAT(steps.at("multi_term_pc"), ElementsAre(4));
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

TEST(DefaultSweeps, SearchForTheCheapestRunsAndThoroughOnesMakeAll) {
  const SearchGoal goal = default_plan().goal.value();
  for (const auto& target : goal.targets)
    EXPECT_TRUE(std::ranges::count(default_accuracies, target.error)) << target.error;
  EXPECT_EQ(goal.targets.size(), 2 * default_accuracies.size());
  EXPECT_FALSE(thorough_plan().goal);
}

TEST(Forecasts, OfAFixedSweepAreItsRuns) {
  Sweep sweep = sweep_of_power();
  sweep.plan = {.resolutions = {16, 64, 48}};
  RecordedSweep book;
  const auto expected = forecast(sweep, book.hooks().recorded);
  book.run(sweep);
  std::map<std::string, std::vector<int>> steps;
  for (const auto& [key, seconds] : expected) {
    steps[key.scheme].push_back(std::get<int>(key.settings.resolution));
    EXPECT_GT(seconds.examination, 0.0);
    EXPECT_GT(seconds.timing, 0.0);
  }
  EXPECT_EQ(steps, book.steps());
  EXPECT_TRUE(forecast(sweep, book.hooks().recorded).empty()) << "nothing is left to do";
}

TEST(Forecasts, RefineAsTheSweepDoes) {
  const Sweep sweep = sweep_of_power();
  RecordedSweep book;
  const auto expected = forecast(sweep, book.hooks().recorded).size();
  EXPECT_GE(expected, 6U);
  EXPECT_LE(expected, 9U);  // the sweep makes 7 runs
}

// A scheme with adaptive step size refuses a number of steps at once, however large it is.
TEST(Forecasts, GiveNoTimeToRunsThatAreRefused) {
  const Sweep sweep{.scenes = {{&scene_factory("relaxation")}},
                    .schemes = {find_scheme("adaptive_pc"), find_scheme("l1")},
                    .plan = {.resolutions = {1 << 20, 1 << 26}}};
  const auto expected = forecast(sweep, [](const RunKey& /*run*/) { return std::optional<Record>(); });
  EXPECT_EQ(expected.size(), 4U);
  for (const auto& [run, seconds] : expected) {
    EXPECT_EQ(seconds.refusal.empty(), run.scheme == "l1") << seconds.refusal;
    if (run.scheme != "l1") {
      EXPECT_LT(seconds.total(), 0.01);
    }
  }
}

// A step of adaptive_pc is as dear at any tolerance, and its steps grow as E^(-1/2): a hundred times smaller
// tolerances take about ten times as long, whatever the first solve of the process took.
TEST(Forecasts, GrowWithTheStepsOfATolerance) {
  Sweep sweep{.scenes = {{&scene_factory("relaxation")}},
              .schemes = {find_scheme("adaptive_pc")},
              .plan = {.resolutions = {Tolerance{1e-5, 1e-5}, Tolerance{1e-9, 1e-9}}}};
  sweep.repeats = {.most = 1, .min_seconds = 0.0, .enough_seconds = 0.0};
  const auto expected = forecast(sweep, [](const RunKey& /*run*/) { return std::optional<Record>(); });
  ASSERT_EQ(expected.size(), 2U);
  const auto [least, most] =
      std::minmax(expected.begin()->second.timing, std::next(expected.begin())->second.timing);
  EXPECT_LT(most, 400.0 * least);
  EXPECT_GT(most, 10.0 * least);
}

// What two short solves foretell of a tolerance of 1e-13 may be years.
TEST(Forecasts, OfARunAreWithinItsBudget) {
  Sweep sweep{.scenes = {{&scene_factory("pendulum")}},
              .schemes = {find_scheme("adaptive_pc"), find_scheme("l1")},
              .plan = {.resolutions = {Tolerance{1e-13, 1e-13}, 100'000'000}}};
  sweep.settings.budget = 0.5;
  sweep.repeats = {.most = 1, .min_seconds = 0.0, .enough_seconds = 0.0};
  const auto expected = forecast(sweep, [](const RunKey& /*run*/) { return std::optional<Record>(); });
  EXPECT_EQ(expected.size(), 2U);
  EXPECT_GE(total_seconds(expected), 2 * 3 * 0.5);  // solved twice, and timed
  for (const auto& [run, seconds] : expected) EXPECT_LT(seconds.total(), 5.0) << run.scheme;
}

RunKey run_with(int steps, const std::string& scheme = "l1") {
  return {.scene = {"power"}, .scheme = scheme, .settings = {.resolution = steps}};
}

TEST(Remainings, LeaveOutTheRunsOfALineThatEnds) {
  SweepEstimate remaining(
      {{run_with(64), {1.0}}, {run_with(128), {2.0}}, {run_with(256), {4.0}}, {run_with(64, "x"), {1.0}}});
  EXPECT_EQ(remaining.part_done(), 0.0);
  remaining.on_event({SweepEvent::Kind::is_done, run_with(64)});
  EXPECT_EQ(remaining.part_done(), 1.0 / 8.0);
  EXPECT_EQ(remaining.runs_expected(), 4U);
  remaining.on_event({SweepEvent::Kind::refinement_ends, run_with(64)});
  EXPECT_EQ(remaining.part_done(), 1.0 / 2.0);
  EXPECT_EQ(remaining.runs_expected(), 2U);
}

TEST(Remainings, TakeThePaceSoFar) {
  SweepEstimate remaining({{run_with(64), {990.0}}, {run_with(128), {100.0}}});
  EXPECT_EQ(remaining.seconds_left(0.0).value(), 1090.0);
  remaining.on_event({SweepEvent::Kind::is_done, run_with(64)});
  EXPECT_DOUBLE_EQ(remaining.seconds_left(1990.0).value(), 200.0);
}

TEST(Remainings, AreUnknownWhileAReferenceIsComputed) {
  SweepEstimate remaining({{run_with(64), {1.0}}, {run_with(64, "x"), {1.0}}});
  remaining.on_event({SweepEvent::Kind::examines, run_with(64), true});
  EXPECT_EQ(remaining.current_run(), "computes the reference of power for l1 N = 64");
  EXPECT_EQ(remaining.seconds_left(100.0), std::nullopt);
  remaining.on_event({SweepEvent::Kind::examines, run_with(64, "x")});
  EXPECT_EQ(remaining.current_run(), "power x N = 64");
  EXPECT_TRUE(remaining.seconds_left(0.0));
}

// For each examination of a sweep, whether it is said to compute the reference.
std::vector<bool> examinations_with_reference(const Sweep& sweep) {
  std::vector<bool> said;
  SweepCallbacks hooks{.recorded = [](const RunKey& /*run*/) { return std::optional<Record>(); },
                       .append = [](const auto& /*run*/) {},
                       .append_times = [](const auto& /*run*/) {},
                       .on_event =
                           [&](const SweepEvent& event) {
                             if (event.kind == SweepEvent::Kind::examines)
                               said.push_back(event.with_reference);
                           }};
  run_sweep(sweep, hooks);
  return said;
}

TEST(Sweeps, SayWhichExaminationComputesTheReference) {
  Sweep sweep = sweep_of_power();
  sweep.plan = {.resolutions = {16, 64}};
  const auto said = examinations_with_reference(sweep);
  ASSERT_GE(said.size(), 2U);
  EXPECT_EQ(std::ranges::count(said, true), 1);
  EXPECT_TRUE(said.front());
}

// Two formulations of one motion, and another motion.
TEST(Sweeps, ComputeTheReferenceOfAMotionOnce) {
  Sweep sweep = sweep_of_power();
  sweep.plan = {.resolutions = {16}};
  sweep.scenes = {parse_variant("fractional_constraint_2d"),
                  parse_variant("fractional_constraint_2d:formulation=multiplier"),
                  parse_variant("fractional_constraint_2d:alpha=0.3")};
  const auto said = examinations_with_reference(sweep);
  EXPECT_GE(said.size(), 3U);
  EXPECT_EQ(std::ranges::count(said, true), 2);
}

// What a sweep takes for the same solution is the same, by a scheme that knows neither reference.
TEST(Sweeps, TakeOnlyEqualSolutionsForOne) {
  constexpr double accuracy = 1e-9, apart = 1e-7;
  std::map<SceneSettings, Vec> ends;
  for (const SceneVariant& variant : sweep_scenes()) {
    const SceneSettings solution = variant.key_of_solution();
    const Scene scene = make_scene(variant);
    const Scheme& scheme = *find_scheme("radau_exponentials");
    if (unsupported_reason(scheme, scene.problem, Tolerance{accuracy, accuracy})) continue;
    if (std::ranges::none_of(variant.factory->parameters, &Parameter::keeps_solution)) continue;
    const auto path = scheme.solve(scene.problem, Tolerance{accuracy, accuracy}, {});
    ASSERT_EQ(path.status, SolveStatus::finished) << variant.label();
    const Vec columns = columns_of(scene.outputs, path).rightCols(1);
    const auto [first, is_first] = ends.try_emplace(solution, columns);
    const double most = apart * (1.0 + columns.cwiseAbs().maxCoeff());
    EXPECT_LE((columns - first->second).cwiseAbs().maxCoeff(), is_first ? 0.0 : most) << variant.label();
  }
  EXPECT_GT(ends.size(), 5U);
}

}  // namespace
}  // namespace fde::bench
