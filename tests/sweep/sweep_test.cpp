#include "sweep/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "support/testing.hpp"

namespace fde {
namespace {

constexpr auto nothing_is_recorded = [](const auto&) { return Recorded::nothing; };
constexpr auto silence = [](std::size_t, std::size_t, const auto&) {};

// A continued sweep times what was examined and examines it no more.
TEST(ContinuedSweeps, TimeWhatIsExamined) {
  std::vector<Record> rows;
  run_sweep(
      {.scenes = {{&scene_maker("power")}},
       .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
       .resolutions = {16},
       .repeats = 1},
      {.recorded =
           [](const RunKey& run) { return run.scheme == "l1" ? Recorded::all_but_times : Recorded::nothing; },
       .append = [&](const auto& some) { rows.insert(rows.end(), some.begin(), some.end()); },
       .progress = silence});
  EXPECT_EQ(std::ranges::count(rows, "ending", &Record::quantity), 1);
  EXPECT_EQ(std::ranges::count(rows, "time_median", &Record::quantity), 2);
}

TEST(Sweeps, TellEachExaminationBeforeTheNextBegins) {
  std::vector<std::string> events;
  run_sweep({.scenes = {{&scene_maker("power")}},
             .schemes = {find_scheme("l1")},
             .resolutions = {16, 32},
             .repeats = 1,
             .threads = 1},
            {.recorded = nothing_is_recorded,
             .append = [&](const auto& some) { events.push_back(some.back().quantity); },
             .progress = [&](std::size_t, std::size_t, const auto& what) { events.push_back(what); }});
  EXPECT_THAT(events, testing::ElementsAre("power l1 N = 16", "ending", "power l1 N = 32", "ending",
                                           "power l1 N = 16, time", "time_median", "power l1 N = 32, time",
                                           "time_median", "done"));
}

// While one thread is appending the others go on: nothing but a failure ends their scenes.
class SlowAppends : public testing::TestWithParam<int> {};

TEST_P(SlowAppends, LoseNoExaminationAndNoTime) {
  std::multiset<RunKey> endings, times;
  const auto relaxation = [](double gamma) {
    return SceneVariant{&scene_maker("relaxation"), {{"gamma", gamma}}};
  };
  const Sweep sweep{.scenes = {relaxation(0.5), relaxation(0.6), relaxation(0.7), relaxation(0.8)},
                    .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
                    .resolutions = {1, 2, 3, 4, 5, 6},
                    .repeats = 1,
                    .threads = 4};
  run_sweep(sweep, {.recorded = nothing_is_recorded,
                    .append =
                        [&](const auto& rows) {
                          const Record& last = rows.back();
                          (last.ending ? endings : times).insert(last.key);
                          if (last.ending) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                        },
                    .progress = silence});
  EXPECT_EQ(endings.size(), sweep.scenes.size() * sweep.schemes.size() * sweep.resolutions.size());
  EXPECT_EQ(std::set<RunKey>(endings.begin(), endings.end()).size(), endings.size());
  EXPECT_TRUE(times == endings);
}

INSTANTIATE_TEST_SUITE_P(Repeats, SlowAppends, testing::Range(0, 3));

}  // namespace
}  // namespace fde
