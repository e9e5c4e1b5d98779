// SPDX-License-Identifier: MIT
// The rows that a sweep appends to its results.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/results_scan.hpp"
#include "fdebench/benchmarks/sweep/described_scene.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

RecordedRun complete(const RunKey& key) {
  RecordedRun run;
  run.add({.key = key, .quantity = "ending", .ending = RunOutcome{}});
  run.add({.key = key, .quantity = "time_minimum", .unit = "s"});
  return run;
}

// Near a jump the times of a solution are as dense as anywhere: rounded to the digits of the file they still
// increase, wherever the jump is and however long the run.
TEST(Sweeps, DescribeASolutionWithAJumpSoThatItIsReadBack) {
  for (const double end : {30.0, 0.013}) {
    for (const double part : {0.4, 0.999}) {
      const SceneVariant variant{
          .maker = &scene_maker("bagley_torvik"), .values = {{"load_until", part * end}}, .until = end};
      const Scene scene = make_scene(variant);
      MemoizedReference reference(scene);
      const auto line = line_of(describe(variant, scene, reference, true));
      EXPECT_NO_THROW(require_readable(line)) << end << " " << part;
      EXPECT_TRUE(parse_line(line).scene->solution) << end << " " << part;
    }
  }
}

TEST(Sweeps, SkipWhatIsKnownAndMeasureTheRest) {
  const Sweep sweep{.scenes = {{&scene_maker("relaxation")}},
                    .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
                    .plan = {{16, 32}},
                    .repeats = {.most = 2}};
  std::vector<Record> all;
  std::size_t calls = 0;
  run_sweep(sweep, {.recorded =
                        [](const RunKey& run) {
                          const bool first =
                              run.scheme == "l1" && run.setup.resolution == StepsOrTolerance(16);
                          return first ? complete(run) : RecordedRun();
                        },
                    .append =
                        [&](const auto& rows) {
                          ++calls;
                          all.insert(all.end(), rows.begin(), rows.end());
                        },
                    .on_event = [](const auto&) {}});
  EXPECT_EQ(calls, 6U);  // an examination and its times for each of three runs
  const auto count = [&](std::string_view quantity) {
    return std::ranges::count(all, quantity, &Record::quantity);
  };
  EXPECT_EQ(count("error_end"), 3);
  EXPECT_EQ(count("ending"), 3);
  EXPECT_EQ(count("newton_iterations"), 1);
  EXPECT_EQ(count("energy_residual"), 0);
}

// D^0.5 y = -y: f = -y has the powers 0, 1/2 and 1 of t at 0. The higher powers do not reduce the rate of
// BDF2.
TEST(Sweeps, RecordStartWeightsOfSchemesThatHaveThem) {
  std::vector<Record> all;
  run_sweep({.scenes = {{&scene_maker("relaxation")}},
             .schemes = {find_scheme("grunwald_letnikov"), find_scheme("bdf2")},
             .plan = {{64, 64}},
             .repeats = {.most = 1}},
            {.recorded = [](const auto&) { return RecordedRun(); },
             .append = [&](const auto& rows) { all.insert(all.end(), rows.begin(), rows.end()); },
             .on_event = [](const auto&) {}});
  std::erase_if(all, [](const Record& row) { return row.quantity != "start_weights"; });
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].key.scheme, "bdf2");
  EXPECT_EQ(all[0].value, 3.0);
}

// What run_sweep() appends to the recorded rows of one run.
std::vector<Record> appended(const Sweep& sweep, const RecordedRun& recorded) {
  std::vector<Record> all;
  run_sweep(sweep, {.recorded = [&](const auto&) { return recorded; },
                    .append = [&](const auto& rows) { all.insert(all.end(), rows.begin(), rows.end()); },
                    .on_event = [](const auto&) {}});
  return all;
}

RecordedRun with(RecordedRun recorded, const std::vector<Record>& rows) {
  for (const Record& row : rows) recorded.add(row);
  return recorded;
}

TEST(Sweeps, ExamineFirstAndTimeLater) {
  Sweep sweep{.scenes = {{&scene_maker("relaxation")}},
              .schemes = {find_scheme("l1")},
              .plan = {{16}},
              .examines_only = true};
  const auto examined = appended(sweep, {});
  EXPECT_TRUE(std::ranges::none_of(examined, is_time));
  EXPECT_TRUE(appended(sweep, with({}, examined)).empty());
  sweep.examines_only = false;
  const auto timed = appended(sweep, with({}, examined));
  EXPECT_TRUE(std::ranges::all_of(timed, is_time));
  EXPECT_EQ(std::ranges::count(timed, "disturbed", &Record::quantity), 1);
  EXPECT_TRUE(appended(sweep, with(with({}, examined), timed)).empty());
}

TEST(Sweeps, TimeAgainWhatWasDisturbedUpToALimit) {
  Sweep sweep{.scenes = {{&scene_maker("relaxation")}}, .schemes = {find_scheme("l1")}, .plan = {{16}}};
  const RunKey key{.scene = {"relaxation"}, .scheme = "l1", .setup = sweep.setup};
  RecordedRun run = complete(key);
  run.add({.key = key, .quantity = "disturbed", .value = 1.0});
  EXPECT_TRUE(appended(sweep, run).empty()) << "only on demand";
  sweep.retimes = true;
  EXPECT_TRUE(appended(sweep, complete(key)).empty()) << "undisturbed";
  for (int timings = 1; timings < most_timings; ++timings) {
    EXPECT_FALSE(appended(sweep, run).empty());
    run.add({.key = key, .quantity = "time_minimum", .unit = "s"});
  }
  EXPECT_TRUE(appended(sweep, run).empty());
}

TEST(Sweeps, MeasureOnceWhatIsAskedForTwice) {
  const SceneVariant power{&scene_maker("power")};
  const auto* l1 = find_scheme("l1");
  int calls = 0;
  run_sweep({.scenes = {power, power}, .schemes = {l1, l1}, .plan = {{16, 16}}, .repeats = {.most = 1}},
            {.recorded = [](const auto&) { return RecordedRun(); },
             .append = [&](const auto&) { ++calls; },
             .on_event = [](const auto&) {}});
  EXPECT_EQ(calls, 2);  // one examination and its times
}

// The lines of results in order: ids of scenes that are described, and of scenes in brackets for their rows.
std::vector<std::string> lines_of_sweep(const Sweep& sweep, const std::set<std::string>& described) {
  std::vector<std::string> lines;
  run_sweep(sweep,
            {.recorded = [](const auto&) { return RecordedRun(); },
             .append = [&](const auto& rows) { lines.push_back("(" + rows.front().key.scene.id + ")"); },
             .on_event = [](const auto&) {},
             .describes =
                 [&](const SceneSettings& scene) {
                   return described.contains(scene.id) || std::ranges::count(lines, scene.id) > 0;
                 },
             .append_scene = [&](const SceneDescription& scene) { lines.push_back(scene.scene.id); }});
  return lines;
}

TEST(Sweeps, DescribeASceneBeforeItsFirstRowsUnlessItIsRecorded) {
  const Sweep sweep{.scenes = {{&scene_maker("power")}, {&scene_maker("relaxation")}},
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
      run_sweep({.scenes = {{&scene_maker("power")}}, .schemes = {find_scheme("l1")}, .plan = {{16, 32}}},
                {.recorded = [](const auto&) { return RecordedRun(); },
                 .append = write,
                 .on_event = [](const auto&) {}}),
      std::runtime_error);
  EXPECT_EQ(calls, 1);
}

// All rows except the times.
std::vector<std::string> rows_with_threads(unsigned threads) {
  const Sweep sweep{
      .scenes = {{&scene_maker("relaxation")}, {&scene_maker("brusselator")}, {&scene_maker("pendulum")}},
      .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
      .plan = {{16, 600}},
      .repeats = {.most = 1},
      .threads = threads};
  std::vector<std::string> rows;
  run_sweep(sweep, {.recorded = [](const auto&) { return RecordedRun(); },
                    .append =
                        [&](const auto& run) {
                          for (const auto& row : run) {
                            if (is_time(row)) continue;
                            rows.push_back(line_of(row, false));
                          }
                        },
                    .on_event = [](const auto&) {}});
  const auto scene = [](const auto& row) { return row.substr(row.find(R"("scene":)")); };
  std::ranges::stable_sort(rows, {}, [&](const auto& row) { return scene(row).substr(0, 20); });
  return rows;
}

// The rows of one scene keep their order; the rows of different scenes interleave.
TEST(Sweeps, GiveTheSameBitsWithAnyNumberOfThreads) {
  const auto alone = rows_with_threads(1);
  EXPECT_GT(alone.size(), 100U);
  EXPECT_EQ(rows_with_threads(2), alone);
  EXPECT_EQ(rows_with_threads(7), alone);
}

TEST(Sweeps, RecordAMissingReferenceAndGoOn) {
  Scene scene = scene_of("brusselator");
  scene.problem.rhs = [rhs = scene.problem.rhs](double t, In y, Out f) {
    rhs(t, y, f);
    if (t > 1.0) f[0] += 1.0;  // the collocation reference fails at a jump that is not in problem.jumps
  };
  MemoizedReference reference(scene);
  for (int repeat = 0; repeat < 2; ++repeat) {
    const auto rows = examine({"brusselator"}, scene, reference, *find_scheme("l1"), {64});
    EXPECT_EQ(rows.back().ending->kind, Verdict::no_reference);
    EXPECT_EQ(std::ranges::count(rows, "rhs_calls", &Record::quantity), 1);  // needs no reference
    EXPECT_EQ(std::ranges::count(rows, "error_end", &Record::quantity), 0);
  }
}

TEST(Sweeps, RecordRefusalsAndFailuresWithTheirReason) {
  const auto rows_of = [](const Scene& scene, std::string_view scheme) {
    MemoizedReference reference(scene);
    return examine({"brusselator"}, scene, reference, *find_scheme(scheme), {256});
  };
  const auto failed = rows_of(scene_of("brusselator"), "adams_pc");
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed[0].ending->kind, SolveStatus::non_finite);
  EXPECT_EQ(failed[0].ending->detail.find("at step "), 0U);
  EXPECT_GT(failed[0].value, 0.0);
  Scene odd = scene_of("brusselator");
  odd.problem.components[0].order = 0.123456789;
  EXPECT_EQ(sentence(*rows_of(odd, "commensurate_adams_pc")[0].ending),
            "refused: needs orders that are multiples of one 1/M with M at most 64");
}

}  // namespace
}  // namespace fde::bench
