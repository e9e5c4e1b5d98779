// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "support/testing.hpp"

namespace fde::bench {
namespace {

constexpr auto nothing_is_recorded = [](const auto&) { return RecordedRun(); };
constexpr auto no_report = [](const auto&) {};

RecordedRun examined(const RunKey& key) {
  RecordedRun run;
  run.add({.key = key, .quantity = "ending", .ending = RunOutcome{}});
  return run;
}

// A continued sweep times the examined runs without a second examination.
TEST(ContinuedSweeps, TimeWhatIsExamined) {
  std::vector<Record> rows;
  run_sweep({.scenes = {{&scene_maker("power")}},
             .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
             .plan = {{16}},
             .repeats = {.most = 1}},
            {.recorded = [](const RunKey& run) { return run.scheme == "l1" ? examined(run) : RecordedRun(); },
             .append = [&](const auto& some) { rows.insert(rows.end(), some.begin(), some.end()); },
             .on_event = no_report});
  EXPECT_EQ(std::ranges::count(rows, "ending", &Record::quantity), 1);
  EXPECT_EQ(std::ranges::count(rows, "time_high", &Record::quantity), 2);
}

std::string words_of(const SweepEvent& event) {
  const std::string run = resolution_text(event.run.setup);
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
  run_sweep({.scenes = {{&scene_maker("power")}},
             .schemes = {find_scheme("l1")},
             .plan = {{16, 32}},
             .repeats = {.most = 1},
             .threads = 1},
            {.recorded = nothing_is_recorded,
             .append = [&](const auto& some) { events.push_back(some.back().quantity); },
             .on_event = [&](const auto& event) { events.push_back(words_of(event)); }});
  EXPECT_THAT(events, testing::ElementsAre("examines N = 16", "ending", "times N = 16", "disturbed",
                                           "N = 16 is done", "examines N = 32", "ending", "times N = 32",
                                           "disturbed", "N = 32 is done", "line ends at N = 32"));
}

// While one thread appends, the others continue; only a failure stops them.
class SlowAppends : public testing::TestWithParam<int> {};

TEST_P(SlowAppends, LoseNoExaminationAndNoTime) {
  std::multiset<RunKey> endings, times;
  const auto relaxation = [](double gamma) {
    return SceneVariant{&scene_maker("relaxation"), {{"gamma", gamma}}};
  };
  const Sweep sweep{.scenes = {relaxation(0.5), relaxation(0.6), relaxation(0.7), relaxation(0.8)},
                    .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
                    .plan = {{1, 2, 3, 4, 5, 6}},
                    .repeats = {.most = 1},
                    .threads = 4};
  run_sweep(sweep, {.recorded = nothing_is_recorded,
                    .append =
                        [&](const auto& rows) {
                          const Record& last = rows.back();
                          (last.ending ? endings : times).insert(last.key);
                          if (last.ending) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                        },
                    .on_event = no_report});
  EXPECT_EQ(endings.size(), sweep.scenes.size() * sweep.schemes.size() * sweep.plan.resolutions.size());
  EXPECT_EQ(std::set<RunKey>(endings.begin(), endings.end()).size(), endings.size());
  EXPECT_TRUE(times == endings);
}

INSTANTIATE_TEST_SUITE_P(TimingRepeats, SlowAppends, testing::Range(0, 3));

}  // namespace
}  // namespace fde::bench
