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
  text += fmt::format("{:3.0f} %  {}/{}", std::floor(100.0 * progress.part), progress.done, progress.total);
  if (progress.seconds_left) text += fmt::format("  {} left", duration_text(*progress.seconds_left));
  if (columns == 0) return text;
  text += "  " + progress.current_run;
  return text.substr(0, static_cast<std::size_t>(std::max(0, columns - 1)));
}

std::function<void(std::size_t, std::size_t, const std::string&)> progress_line(const Streams& streams) {
  using namespace std::chrono_literals;
  using Clock = std::chrono::steady_clock;
  return
      [&streams, shown = Clock::now()](std::size_t done, std::size_t total, const std::string& what) mutable {
        const bool terminal = streams.columns > 0;
        if (!terminal && Clock::now() - shown < 1min) return;
        shown = Clock::now();
        const double part = total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 1.0;
        show_line(streams, {.part = part, .done = done, .total = total, .current_run = what});
        if (terminal && done == total) streams.err << '\n';
      };
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
  const double seconds = remaining_.seconds_left(0.0);
  if (seconds >= worth_saying) {
    streams_.err << fmt::format("{}{} runs, about {}\n", count_is_exact ? "" : "about ",
                                remaining_.runs_expected(), duration_text(seconds));
    streams_.err.flush();
  }
  if (streams_.columns > 0) return;
  lines_ = std::jthread([this, between_lines](const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, stop, between_lines, [&] { return stop.stop_requested(); })) show();
  });
}

SweepProgress::~SweepProgress() {
  const std::scoped_lock lock(mutex_);
  if (line_is_open_) streams_.err << std::endl;
}

void SweepProgress::on_event(const SweepEvent& event) {
  using namespace std::chrono_literals;
  const std::scoped_lock lock(mutex_);
  remaining_.on_event(event);
  const bool soon = line_is_open_ && Clock::now() - shown_ < 100ms;
  if (streams_.columns > 0 && !soon) show();
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
