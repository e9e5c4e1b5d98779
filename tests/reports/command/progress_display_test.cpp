// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/progress_display.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <thread>

namespace fde::bench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const Progress quarter{
    .part = 0.25, .done = 530, .total = 2120, .seconds_left = 151.0, .current_run = "pendulum l1 N = 64"};

TEST(ProgressTexts, FillATerminalOfEightyColumns) {
  const auto text = progress_text(quarter, 80);
  EXPECT_EQ(text, "[#####...............]   25 %  530/2120  2 min 31 s left  pendulum l1 N = 64");
  EXPECT_LT(text.size(), 80U);
}

TEST(ProgressTexts, AreShorterThanAnyTerminal) {
  Progress longest = quarter;
  longest.current_run = std::string(200, 'x');
  for (const int columns : {1, 10, 40, 59, 60, 80, 200}) {
    EXPECT_LT(progress_text(longest, columns).size(), static_cast<std::size_t>(columns)) << columns;
  }
  EXPECT_EQ(progress_text(longest, 80).size(), 79U);
  EXPECT_THAT(progress_text(quarter, 40), StartsWith(" 25 %  530/2120  2 min 31 s left  pend"));
}

TEST(ProgressTexts, OfNoTerminalHaveNoBar) {
  EXPECT_EQ(progress_text(quarter, 0), " 25 %  530/2120  2 min 31 s left");
}

// The progress line of work with an unknown total.
std::string shown_work(const std::string& what, int columns) {
  std::ostringstream out, err;
  show_work({.out = out, .err = err, .columns = columns}, 42, 0, what);
  return err.str();
}

TEST(Work, IsShownInOneLineOfATerminalAndInALineElsewhere) {
  EXPECT_EQ(shown_work("t = 1", 0), "t = 1  42 steps\n");
  EXPECT_EQ(shown_work("", 0), "42 steps\n");
  EXPECT_EQ(shown_work(std::string(200, 'x'), 80), "\r" + std::string(79, 'x'));
  EXPECT_EQ(shown_work("t = 1", 20), "\rt = 1  42 steps    ");
}

TEST(Durations, AreTextsOfTwoUnits) {
  EXPECT_EQ(duration_text(51.6), "52 s");
  EXPECT_EQ(duration_text(59.6), "1 min 00 s");
  EXPECT_EQ(duration_text(185.0), "3 min 05 s");
  EXPECT_EQ(duration_text(4320.0), "1 h 12 min");
}

RunKey run_with(int steps) { return {.scene = {"power"}, .scheme = "l1", .setup = {.resolution = steps}}; }

// The standard error of a sweep of two runs with this expected total time.
std::string shown(double seconds, int columns) {
  std::ostringstream out, err;
  const Streams streams{.out = out, .err = err, .columns = columns};
  {
    SweepProgress progress(streams, {{run_with(64), seconds / 2}, {run_with(128), seconds / 2}}, true);
    progress.on_event({SweepEvent::Kind::examines, run_with(64)});
    progress.on_event({SweepEvent::Kind::is_done, run_with(64)});
  }
  return err.str();
}

TEST(SweepsProgress, SaysBeforeALongSweepHowManyRunsItTakesAndHowLong) {
  EXPECT_EQ(shown(150.0, 0), "2 runs, about 2 min 30 s\n");
  EXPECT_EQ(shown(1.0, 0), "") << "a short sweep says nothing, nor does one of less than a minute go on";
}

TEST(SweepsProgress, OverwritesOneLineOfATerminalAndEndsIt) {
  const auto text = shown(150.0, 80);
  EXPECT_THAT(text, StartsWith("2 runs, about 2 min 30 s\n\r[..........."));
  EXPECT_THAT(text, HasSubstr("power l1 N = 64"));
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
}

// Progress lines also appear during a run that takes longer than their interval.
TEST(SweepsProgress, GoesOnDuringALongRunWhereThereIsNoTerminal) {
  std::ostringstream out, err;
  {
    const Streams streams{.out = out, .err = err, .columns = 0};
    SweepProgress progress(streams, {{run_with(64), 1.0}}, true, std::chrono::milliseconds(5));
    progress.on_event({SweepEvent::Kind::examines, run_with(64)});
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  EXPECT_THAT(err.str(), StartsWith("  0 %  0/1  1 s left\n  0 %  0/1  1 s left\n"));
}

}  // namespace
}  // namespace fde::bench
