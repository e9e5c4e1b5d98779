// SPDX-License-Identifier: MIT
// The runs that a sweep appends to its results.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/sweep/described_scene.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// A timed run without measures.
Record complete(const RunKey& key) {
  Record run{.key = key, .timing = {.count = 1}};
  run.timing.values.set("time_minimum", 1.0);
  return run;
}

// What a sweep appends, where `recorded` is known: the examined and the timed runs.
struct AppendedRuns {
  std::vector<Record> examined{}, timed{};
};
AppendedRuns appended(const Sweep& sweep, const RecordedLookup& recorded) {
  AppendedRuns all;
  run_sweep(sweep, {.recorded = recorded,
                    .append = [&](const Record& run) { all.examined.push_back(run); },
                    .append_times = [&](const Record& run) { all.timed.push_back(run); },
                    .on_event = [](const auto&) {}});
  return all;
}

constexpr auto nothing = [](const RunKey&) { return std::optional<Record>(); };

// Near a jump the times of a solution are as dense as anywhere: rounded to the digits of the file they still
// increase, wherever the jump is and however long the run.
TEST(Sweeps, DescribeASolutionWithAJumpSoThatItIsReadBack) {
  for (const double end : {30.0, 0.013}) {
    for (const double part : {0.4, 0.999}) {
      const SceneVariant variant{
          .factory = &scene_factory("bagley_torvik"), .values = {{"load_until", part * end}}, .until = end};
      const Scene scene = make_scene(variant);
      MemoizedReference reference(scene);
      const auto line = line_of(describe(variant, scene, reference, true));
      EXPECT_TRUE(std::get<SceneDescription>(parse_line(line)).solution) << end << " " << part;
    }
  }
}

TEST(Sweeps, SkipWhatIsKnownAndMeasureTheRest) {
  const Sweep sweep{.scenes = {{&scene_factory("relaxation")}},
                    .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
                    .plan = {{16, 32}},
                    .repeats = {.most = 2}};
  const auto [examined, timed] = appended(sweep, [](const RunKey& run) {
    const bool first = run.scheme == "l1" && run.settings.resolution == StepsOrTolerance(16);
    return first ? std::optional(complete(run)) : std::nullopt;
  });
  EXPECT_EQ(examined.size(), 3U);
  EXPECT_EQ(timed.size(), 3U);
  for (const Record& run : examined) {
    EXPECT_TRUE(run["error_end"]);
    EXPECT_EQ(run["newton_iterations"].has_value(), run.key.scheme == "l1");
    EXPECT_FALSE(run["energy_residual"]);
  }
}

// D^0.5 y = -y: f = -y has the powers 0, 1/2 and 1 of t at 0. The higher powers do not reduce the rate of
// BDF2.
TEST(Sweeps, RecordStartWeightsOfSchemesThatHaveThem) {
  const auto [examined, timed] = appended({.scenes = {{&scene_factory("relaxation")}},
                                           .schemes = {find_scheme("grunwald_letnikov"), find_scheme("bdf2")},
                                           .plan = {{64, 64}},
                                           .repeats = {.most = 1}},
                                          nothing);
  ASSERT_EQ(examined.size(), 2U);
  EXPECT_FALSE(examined[0]["start_weights"]);
  EXPECT_EQ(examined[1].key.scheme, "bdf2");
  EXPECT_EQ(examined[1]["start_weights"], 3.0);
}

TEST(Sweeps, ExamineFirstAndTimeLater) {
  Sweep sweep{.scenes = {{&scene_factory("relaxation")}},
              .schemes = {find_scheme("l1")},
              .plan = {{16}},
              .examines_only = true};
  const auto [examined, untimed] = appended(sweep, nothing);
  ASSERT_EQ(examined.size(), 1U);
  EXPECT_TRUE(untimed.empty());
  EXPECT_TRUE(examined[0].timing.values.empty());
  const auto with = [](const Record& run) { return [run](const RunKey&) { return std::optional(run); }; };
  EXPECT_TRUE(appended(sweep, with(examined[0])).examined.empty());
  sweep.examines_only = false;
  const auto later = appended(sweep, with(examined[0]));
  EXPECT_TRUE(later.examined.empty());
  ASSERT_EQ(later.timed.size(), 1U);
  EXPECT_TRUE(later.timed[0]["disturbed"]);
  EXPECT_TRUE(appended(sweep, with(later.timed[0])).timed.empty());
}

TEST(Sweeps, TimeAgainWhatWasDisturbedUpToALimit) {
  Sweep sweep{.scenes = {{&scene_factory("relaxation")}}, .schemes = {find_scheme("l1")}, .plan = {{16}}};
  Record run = complete({.scene = {"relaxation"}, .scheme = "l1", .settings = sweep.settings});
  const auto timed = [&] {
    return appended(sweep, [&](const RunKey&) { return std::optional(run); }).timed.size();
  };
  sweep.retimes = true;
  EXPECT_EQ(timed(), 0U) << "undisturbed";
  run.timing.values.set("disturbed", 1.0);
  for (; run.timing.count < most_timings; ++run.timing.count) EXPECT_EQ(timed(), 1U);
  EXPECT_EQ(timed(), 0U);
  run.timing.count = 1;
  sweep.retimes = false;
  EXPECT_EQ(timed(), 0U) << "only on demand";
}

TEST(Sweeps, MeasureOnceWhatIsAskedForTwice) {
  const SceneVariant power{&scene_factory("power")};
  const auto* l1 = find_scheme("l1");
  const auto [examined, timed] = appended(
      {.scenes = {power, power}, .schemes = {l1, l1}, .plan = {{16, 16}}, .repeats = {.most = 1}}, nothing);
  EXPECT_EQ(examined.size(), 1U);
  EXPECT_EQ(timed.size(), 1U);
}

// The lines of results in order: ids of scenes that are described, and of scenes in brackets for their runs.
std::vector<std::string> lines_of_sweep(const Sweep& sweep, const std::set<std::string>& described) {
  std::vector<std::string> lines;
  const auto append = [&](const Record& run) { lines.push_back("(" + run.key.scene.id + ")"); };
  run_sweep(sweep, {.recorded = nothing,
                    .append = append,
                    .append_times = append,
                    .on_event = [](const auto&) {},
                    .describes =
                        [&](const SceneSettings& scene) {
                          return described.contains(scene.id) || std::ranges::count(lines, scene.id) > 0;
                        },
                    .append_scene = [&](const SceneDescription& scene) { lines.push_back(scene.scene.id); }});
  return lines;
}

TEST(Sweeps, DescribeASceneBeforeItsFirstRunUnlessItIsRecorded) {
  const Sweep sweep{.scenes = {{&scene_factory("power")}, {&scene_factory("relaxation")}},
                    .schemes = {find_scheme("l1")},
                    .plan = {{16, 32}},
                    .repeats = {.most = 1},
                    .threads = 1};
  const std::vector<std::string> both{"power",   "(power)",      "relaxation", "(relaxation)",
                                      "(power)", "(relaxation)", "(power)",    "(relaxation)",
                                      "(power)", "(relaxation)"};
  EXPECT_EQ(lines_of_sweep(sweep, {}), both);
  std::vector<std::string> one = both;
  std::erase(one, "power");
  EXPECT_EQ(lines_of_sweep(sweep, {"power"}), one);
}

TEST(Sweeps, StopAtTheFirstFailureToWrite) {
  int calls = 0;
  const auto write = [&](const auto&) {
    ++calls;
    throw std::runtime_error("disk full");
  };
  EXPECT_THROW(
      run_sweep(
          {.scenes = {{&scene_factory("power")}}, .schemes = {find_scheme("l1")}, .plan = {{16, 32}}},
          {.recorded = nothing, .append = write, .append_times = write, .on_event = [](const auto&) {}}),
      std::runtime_error);
  EXPECT_EQ(calls, 1);
}

// The lines of the examined runs, scene by scene.
std::vector<std::string> lines_with_threads(unsigned threads) {
  const Sweep sweep{.scenes = {{&scene_factory("relaxation")},
                               {&scene_factory("brusselator")},
                               {&scene_factory("pendulum")}},
                    .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
                    .plan = {{16, 600}},
                    .repeats = {.most = 1},
                    .threads = threads};
  auto examined = appended(sweep, nothing).examined;
  std::ranges::stable_sort(examined, {}, [](const Record& run) { return run.key.scene.id; });
  std::vector<std::string> lines;
  for (const Record& run : examined) lines.push_back(line_of(run));
  return lines;
}

// The runs of one scene keep their order; those of different scenes interleave.
TEST(Sweeps, GiveTheSameBitsWithAnyNumberOfThreads) {
  const auto alone = lines_with_threads(1);
  EXPECT_EQ(alone.size(), 12U);
  EXPECT_EQ(lines_with_threads(2), alone);
  EXPECT_EQ(lines_with_threads(7), alone);
}

TEST(Sweeps, RecordAMissingReferenceAndGoOn) {
  Scene scene = scene_of("brusselator");
  scene.problem.rhs = [rhs = scene.problem.rhs](double t, In y, Out f) {
    rhs(t, y, f);
    if (t > 1.0) f[0] += 1.0;  // the collocation reference fails at a jump that is not in problem.jumps
  };
  MemoizedReference reference(scene);
  for (int repeat = 0; repeat < 2; ++repeat) {
    const auto run = examine({"brusselator"}, scene, reference, *find_scheme("l1"), {64});
    EXPECT_EQ(run.ending.kind, Verdict::no_reference);
    EXPECT_TRUE(run["rhs_calls"]);  // needs no reference
    EXPECT_FALSE(run["error_end"]);
  }
}

// The solution changes near t = 1, far before the first time at which all runs are compared.
TEST(Sweeps, CompareAdaptiveRunsAtTheirOwnSteps) {
  const SceneVariant variant = parse_variant("relaxation:until=1e100");
  const Scene scene = make_scene(variant);
  MemoizedReference reference(scene);
  constexpr double tolerance = 1e-6;
  const Record run = examine(variant.key(), scene, reference, *find_scheme("radau_exponentials"),
                             {.resolution = Tolerance{tolerance, tolerance}});
  EXPECT_GT(*run["error_maximum"], 1e-3 * tolerance);
  EXPECT_LT(*run["error_maximum"], 100.0 * tolerance);
}

TEST(Sweeps, RecordRefusalsAndFailuresWithTheirReason) {
  const auto run_of = [](const Scene& scene, std::string_view scheme) {
    MemoizedReference reference(scene);
    return examine({"brusselator"}, scene, reference, *find_scheme(scheme), {256});
  };
  const auto failed = run_of(scene_of("brusselator"), "adams_pc");
  EXPECT_TRUE(failed.values.empty());
  EXPECT_EQ(failed.ending.kind, SolveStatus::non_finite);
  EXPECT_EQ(failed.ending.detail.find("at step "), 0U);
  EXPECT_GT(failed.ended_at, 0.0);
  Scene odd = scene_of("brusselator");
  odd.problem.components[0].order = 0.123456789;
  EXPECT_EQ(sentence(run_of(odd, "commensurate_adams_pc").ending),
            "refused: needs orders that are multiples of one 1/M with M at most 64");
}

}  // namespace
}  // namespace fde::bench
