// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <set>
#include <thread>

#include "support/testing.hpp"

namespace fde::bench {
namespace {

constexpr auto nothing_is_recorded = [](const auto&) { return std::optional<Record>(); };
constexpr auto no_report = [](const auto&) {};

// A continued sweep times the examined runs without a second examination.
TEST(ContinuedSweeps, TimeWhatIsExamined) {
  std::vector<std::string> examined, timed;
  run_sweep({.scenes = {{&scene_factory("power")}},
             .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
             .plan = {{16}},
             .repeats = {.most = 1}},
            {.recorded =
                 [](const RunKey& run) {
                   return run.scheme == "l1" ? std::optional(Record{.key = run}) : std::nullopt;
                 },
             .append = [&](const Record& run) { examined.push_back(run.key.scheme); },
             .append_times =
                 [&](const Record& run) {
                   EXPECT_GT(run["time_high"], 0.0);
                   timed.push_back(run.key.scheme);
                 },
             .on_event = no_report});
  EXPECT_THAT(examined, ElementsAre("adams_pc"));
  EXPECT_THAT(timed, ElementsAre("l1", "adams_pc"));
}

std::string words_of(const SweepEvent& event) {
  const std::string run = resolution_text(event.run.settings);
  switch (event.kind) {
    case SweepEvent::Kind::examines:
      return "examines " + run;
    case SweepEvent::Kind::times:
      return "times " + run;
    case SweepEvent::Kind::is_done:
      return run + " is done";
    case SweepEvent::Kind::refinement_ends:
      return "line ends at " + run;
  }
  return {};
}

TEST(Sweeps, TakeOneResolutionAfterTheOtherAndReportEachRun) {
  std::vector<std::string> events;
  run_sweep({.scenes = {{&scene_factory("power")}},
             .schemes = {find_scheme("l1")},
             .plan = {{16, 32}},
             .repeats = {.most = 1},
             .threads = 1},
            {.recorded = nothing_is_recorded,
             .append = [&](const auto&) { events.emplace_back("appends"); },
             .append_times = [&](const auto&) { events.emplace_back("appends times"); },
             .on_event = [&](const auto& event) { events.push_back(words_of(event)); }});
  EXPECT_THAT(events, ElementsAre("examines N = 16", "appends", "times N = 16", "appends times",
                                  "N = 16 is done", "examines N = 32", "appends", "times N = 32",
                                  "appends times", "N = 32 is done", "line ends at N = 32"));
}

// While one thread appends, the others continue; only a failure stops them.
class SlowAppends : public testing::TestWithParam<int> {};

TEST_P(SlowAppends, LoseNoExaminationAndNoTime) {
  std::multiset<RunKey> runs, times;
  const auto relaxation = [](double gamma) {
    return SceneVariant{&scene_factory("relaxation"), {{"gamma", gamma}}};
  };
  const Sweep sweep{.scenes = {relaxation(0.5), relaxation(0.6), relaxation(0.7), relaxation(0.8)},
                    .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
                    .plan = {{1, 2, 3, 4, 5, 6}},
                    .repeats = {.most = 1},
                    .threads = 4};
  run_sweep(sweep, {.recorded = nothing_is_recorded,
                    .append =
                        [&](const Record& run) {
                          runs.insert(run.key);
                          std::this_thread::sleep_for(std::chrono::milliseconds(1));
                        },
                    .append_times = [&](const Record& run) { times.insert(run.key); },
                    .on_event = no_report});
  EXPECT_EQ(runs.size(), sweep.scenes.size() * sweep.schemes.size() * sweep.plan.resolutions.size());
  EXPECT_EQ(std::set<RunKey>(runs.begin(), runs.end()).size(), runs.size());
  EXPECT_TRUE(times == runs);
}

INSTANTIATE_TEST_SUITE_P(TimingRepeats, SlowAppends, testing::Range(0, 3));

}  // namespace
}  // namespace fde::bench
