// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/progress_display.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <sstream>
#include <thread>

#include "support/matchers.hpp"

namespace fde::bench {
namespace {

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
  Progress unknown = quarter;
  unknown.seconds_left = {};
  EXPECT_EQ(progress_text(unknown, 0), " 25 %  530/2120  pendulum l1 N = 64");
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

RunKey run_with(int steps) { return {.scene = {"power"}, .scheme = "l1", .settings = {.resolution = steps}}; }

// The standard error of a sweep of two runs with this expected total time, of which the first takes some
// time.
std::string shown(double seconds, int columns, std::chrono::milliseconds taken = {}) {
  std::ostringstream out, err;
  const Streams streams{.out = out, .err = err, .columns = columns};
  {
    SweepProgress progress(streams, {{run_with(64), {seconds / 2}}, {run_with(128), {seconds / 2}}}, true);
    progress.on_event({SweepEvent::Kind::examines, run_with(64)});
    std::this_thread::sleep_for(taken);
    progress.on_event({SweepEvent::Kind::examines, run_with(64)});
    progress.on_event({SweepEvent::Kind::is_done, run_with(64)});
  }
  return err.str();
}

TEST(SweepsProgress, SaysBeforeALongSweepHowManyRunsItTakesAndHowLong) {
  EXPECT_EQ(shown(150.0, 0), "2 runs, about 2 min 30 s\n");
  EXPECT_EQ(shown(1.0, 0), "") << "a short sweep says nothing, nor does one of less than a minute go on";
}

TEST(SweepsProgress, OfATerminalBeginsAfterTwoSecondsAndIsErased) {
  EXPECT_EQ(shown(150.0, 80), "2 runs, about 2 min 30 s\n");
  const auto text = shown(150.0, 80, before_progress);
  EXPECT_THAT(text, StartsWith("2 runs, about 2 min 30 s\n\r[..........."));
  EXPECT_THAT(text, HasSubstr("power l1 N = 64"));
  EXPECT_THAT(text, EndsWith("\r" + std::string(79, ' ') + "\r"));
}

TEST(SweepsProgress, IsSilentWhereQuietIsAsked) {
  std::ostringstream out, err;
  const Streams streams{.out = out, .err = err, .columns = 80, .quiet = true};
  { SweepProgress progress(streams, {{run_with(64), {150.0}}}, true, std::chrono::milliseconds(5)); }
  EXPECT_EQ(err.str(), "");
}

TEST(SweepsProgress, SaysOfAReferenceThatItIsComputed) {
  std::ostringstream out, err;
  {
    const Streams streams{.out = out, .err = err};
    SweepProgress progress(streams, {{run_with(64), {1.0}}}, true, std::chrono::milliseconds(5));
    progress.on_event({SweepEvent::Kind::examines, run_with(64), true});
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  EXPECT_THAT(err.str(), HasSubstr("  0 %  0/1  computes the reference of power for l1 N = 64\n"));
}

// What a progress line writes while work goes on for a while.
std::string shown_line(int columns, bool quiet, const std::function<void(ProgressLine&)>& work) {
  std::ostringstream out, err;
  const Streams streams{.out = out, .err = err, .columns = columns, .quiet = quiet};
  {
    ProgressLine line(streams, "reads a file", false, std::chrono::milliseconds(5));
    work(line);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  }
  return err.str();
}

TEST(ProgressLines, AreShownOnATerminalAndErased) {
  const auto nothing = [](ProgressLine& /*line*/) {};
  const auto text = shown_line(20, false, nothing);
  EXPECT_THAT(text, StartsWith("\rreads a file  0 s  \r"));
  EXPECT_THAT(text, EndsWith("\r" + std::string(19, ' ') + "\r"));
  EXPECT_EQ(shown_line(0, false, nothing), "");
  EXPECT_EQ(shown_line(20, true, nothing), "");
  EXPECT_THAT(shown_line(80, false, [](ProgressLine& line) { line.set(1, 4, "l1"); }),
              HasSubstr("\r[#####...............]   25 %  1/4  0 s left  l1"));
}

TEST(ProgressLines, MakeWayForAMessage) {
  std::ostringstream out, err;
  const Streams streams{.out = out, .err = err, .columns = 20};
  {
    ProgressLine line(streams, "l1", false, std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    line.interrupt([&] { err << "message\n"; });
  }
  EXPECT_THAT(err.str(), StartsWith("\rl1  0 s            \r"));
  EXPECT_THAT(err.str(), EndsWith("\r" + std::string(19, ' ') + "\rmessage\n"));
}

// Progress lines also appear during a run that takes longer than their interval.
TEST(SweepsProgress, GoesOnDuringALongRunWhereThereIsNoTerminal) {
  std::ostringstream out, err;
  {
    const Streams streams{.out = out, .err = err, .columns = 0};
    SweepProgress progress(streams, {{run_with(64), {1.0}}}, true, std::chrono::milliseconds(5));
    progress.on_event({SweepEvent::Kind::examines, run_with(64)});
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  EXPECT_THAT(err.str(), StartsWith("  0 %  0/1  1 s left\n  0 %  0/1  1 s left\n"));
}

}  // namespace
}  // namespace fde::bench
