// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/progress_display.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

namespace fde::bench {
namespace {

using std::chrono::duration;

// On a terminal overwrites the current line, otherwise prints a new line.
void show_line(const Streams& streams, const std::string& text) {
  if (streams.quiet) return;
  if (streams.columns > 0) {
    streams.err << fmt::format("\r{0:<{1}.{1}}", text, streams.columns - 1);
  } else {
    streams.err << text << '\n';
  }
  streams.err.flush();
}

void show_line(const Streams& streams, const Progress& progress) {
  show_line(streams, progress_text(progress, streams.columns));
}

void erase_line(const Streams& streams) {
  streams.err << fmt::format("\r{:{}}\r", "", streams.columns - 1) << std::flush;
}

std::string bar_text(double part) {
  constexpr int width = 20;
  const int done = std::clamp(static_cast<int>(std::floor(part * width)), 0, width);
  return fmt::format("[{:#<{}}{:.<{}}]  ", "", done, "", width - done);
}

}  // namespace

std::string duration_text(double seconds) {
  constexpr int minute = 60, hour = 60 * minute;
  const auto whole = std::llround(seconds);
  if (whole < minute) return fmt::format("{} s", whole);
  if (whole < hour) return fmt::format("{} min {:02} s", whole / minute, whole % minute);
  return fmt::format("{} h {:02} min", whole / hour, whole % hour / minute);
}

std::string progress_text(const Progress& progress, int columns) {
  constexpr int fewest_with_bar = 60;
  std::string text = columns >= fewest_with_bar ? bar_text(progress.part) : "";
  text += fmt::format("{:3.0f} %", std::floor(100.0 * progress.part));
  if (progress.total > 0) text += fmt::format("  {}/{}", progress.done, progress.total);
  if (progress.seconds_left) text += fmt::format("  {} left", duration_text(*progress.seconds_left));
  if (columns == 0 && (progress.seconds_left || progress.total == 0)) return text;
  text += "  " + progress.current_run;
  return columns == 0 ? text : text.substr(0, static_cast<std::size_t>(std::max(0, columns - 1)));
}

ProgressLine::ProgressLine(const Streams& streams, std::string what, bool lines_elsewhere,
                           std::chrono::milliseconds before)
    : streams_(streams), progress_{.current_run = std::move(what)} {
  using namespace std::chrono_literals;
  const bool terminal = streams.columns > 0;
  if (streams.quiet || (!terminal && !lines_elsewhere)) return;
  const std::chrono::milliseconds first = terminal ? before : 60'000ms, between = terminal ? 200ms : 60'000ms;
  ticks_ = std::jthread([this, first, between](const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    for (auto wait = first; !ended_.wait_for(lock, stop, wait, [&] { return stop.stop_requested(); });
         wait = between)
      show();
  });
}

ProgressLine::~ProgressLine() {
  ticks_ = {};
  erase();
}

void ProgressLine::set(Progress progress) {
  const std::scoped_lock lock(mutex_);
  if (progress.current_run != progress_.current_run) start_ = Clock::now();
  progress_ = std::move(progress);
}

void ProgressLine::set(std::size_t done, std::size_t total, const std::string& what) {
  const double part = total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 0.0;
  set({.part = part, .done = done, .total = total, .current_run = what});
}

void ProgressLine::interrupt(const std::function<void()>& action) {
  const std::scoped_lock lock(mutex_);
  erase();
  action();
}

void ProgressLine::show() {
  constexpr double least_part = 0.01;  // a time left would be a guess before
  const double taken = duration<double>(Clock::now() - start_).count();
  line_is_open_ = streams_.columns > 0;
  if (progress_.part == 0.0 && progress_.total == 0) {
    return show_line(streams_, fmt::format("{}  {}", progress_.current_run, duration_text(taken)));
  }
  if (progress_.part >= least_part) progress_.seconds_left = taken * (1.0 - progress_.part) / progress_.part;
  show_line(streams_, progress_);
}

void ProgressLine::erase() {
  if (line_is_open_) erase_line(streams_);
  line_is_open_ = false;
}

void show_work(const Streams& streams, std::size_t done, std::size_t total, const std::string& what) {
  if (total > 0) {
    const double part = static_cast<double>(done) / static_cast<double>(total);
    return show_line(streams, {.part = part, .done = done, .total = total, .current_run = what});
  }
  show_line(streams, fmt::format("{}{}{} steps", what, what.empty() ? "" : "  ", done));
}

SweepProgress::SweepProgress(const Streams& streams, Forecast expected, bool count_is_exact,
                             std::chrono::milliseconds between_lines)
    : streams_(streams), remaining_(std::move(expected)) {
  constexpr double worth_saying = 5.0;
  const double seconds = remaining_.seconds_left(0.0).value_or(0.0);
  if (streams_.quiet) return;
  if (seconds >= worth_saying) {
    streams_.err << fmt::format("{}{} runs, about {}\n", count_is_exact ? "" : "about ",
                                remaining_.runs_expected(), duration_text(seconds));
    streams_.err.flush();
  }
  const bool terminal = streams_.columns > 0;
  const auto first = terminal ? before_progress : between_lines;
  const auto between = terminal ? std::chrono::milliseconds(std::chrono::seconds(1)) : between_lines;
  lines_ = std::jthread([this, first, between](const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    for (auto wait = first; !ended_.wait_for(lock, stop, wait, [&] { return stop.stop_requested(); });
         wait = between)
      show();
  });
}

SweepProgress::~SweepProgress() {
  lines_ = {};
  const std::scoped_lock lock(mutex_);
  if (line_is_open_) erase_line(streams_);
}

void SweepProgress::on_event(const SweepEvent& event) {
  using namespace std::chrono_literals;
  const std::scoped_lock lock(mutex_);
  const auto now = Clock::now();
  if (remaining_.seeks_reference()) start_ += now - last_event_;
  last_event_ = now;
  remaining_.on_event(event);
  const bool soon = now - shown_ < (line_is_open_ ? 100ms : before_progress);
  if (streams_.columns > 0 && !streams_.quiet && !soon) show();
}

void SweepProgress::show() {
  shown_ = Clock::now();
  line_is_open_ = streams_.columns > 0;
  show_line(streams_, {.part = remaining_.part_done(),
                       .done = remaining_.runs_done(),
                       .total = remaining_.runs_expected(),
                       .seconds_left = remaining_.seconds_left(duration<double>(shown_ - start_).count()),
                       .current_run = remaining_.current_run()});
}

}  // namespace fde::bench
