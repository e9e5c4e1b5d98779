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

constexpr auto nothing_is_known = [](const auto&, const auto&, int) { return Stage::missing; };
constexpr auto silence = [](std::size_t, std::size_t, const auto&) {};

// A continued sweep times what was examined and examines it no more.
TEST(ContinuedSweeps, TimeWhatIsExamined) {
  std::vector<Record> rows;
  run_sweep({.scenes = {{&scene_maker("power")}},
             .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
             .steps = {16},
             .repeats = 1},
            {.stage = [](const auto&, const auto& scheme,
                         int) { return scheme == "l1" ? Stage::examined : Stage::missing; },
             .append = [&](const auto& some) { rows.insert(rows.end(), some.begin(), some.end()); },
             .progress = silence});
  EXPECT_EQ(std::ranges::count(rows, "outcome", &Record::quantity), 1);
  EXPECT_EQ(std::ranges::count(rows, "time_median", &Record::quantity), 2);
  EXPECT_EQ(std::ranges::count(rows, "timed", &Record::status), 2);
}

TEST(Sweeps, TellEachExaminationBeforeTheNextBegins) {
  std::vector<std::string> events;
  run_sweep({.scenes = {{&scene_maker("power")}},
             .schemes = {find_scheme("l1")},
             .steps = {16, 32},
             .repeats = 1,
             .threads = 1},
            {.stage = nothing_is_known,
             .append = [&](const auto& some) { events.push_back(some.back().quantity); },
             .progress = [&](std::size_t, std::size_t, const auto& what) { events.push_back(what); }});
  EXPECT_THAT(events, testing::ElementsAre("power l1 N = 16", "outcome", "power l1 N = 32", "outcome",
                                           "power l1 N = 16, time", "time_median", "power l1 N = 32, time",
                                           "time_median", "done"));
}

// While one thread is appending the others go on: nothing but a failure ends their scenes.
class SlowAppends : public testing::TestWithParam<int> {};

TEST_P(SlowAppends, LoseNoExaminationAndNoTime) {
  using Key = std::tuple<std::string, std::string, int>;
  std::multiset<Key> outcomes, times;
  const std::vector<int> steps{1, 2, 3, 4, 5, 6};
  const auto relaxation = [](double gamma) {
    return SceneVariant{&scene_maker("relaxation"), {{"gamma", gamma}}};
  };
  const Sweep sweep{.scenes = {relaxation(0.5), relaxation(0.6), relaxation(0.7), relaxation(0.8)},
                    .schemes = {find_scheme("l1"), find_scheme("adams_pc")},
                    .steps = steps,
                    .repeats = 1,
                    .threads = 4};
  run_sweep(sweep, {.stage = nothing_is_known,
                    .append =
                        [&](const auto& rows) {
                          const Record& last = rows.back();
                          auto& seen = last.quantity == "outcome" ? outcomes : times;
                          seen.insert({last.scene, last.scheme, last.steps});
                          if (last.quantity == "outcome")
                            std::this_thread::sleep_for(std::chrono::milliseconds(1));
                        },
                    .progress = silence});
  EXPECT_EQ(outcomes.size(), sweep.scenes.size() * sweep.schemes.size() * steps.size());
  EXPECT_EQ(std::set<Key>(outcomes.begin(), outcomes.end()).size(), outcomes.size());
  EXPECT_TRUE(times == outcomes);
}

INSTANTIATE_TEST_SUITE_P(Repeats, SlowAppends, testing::Range(0, 3));

}  // namespace
}  // namespace fde
