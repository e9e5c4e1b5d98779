// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "fdebench/benchmarks/requests/run_progress.hpp"
#include "fdebench/benchmarks/sweep/sweep_estimate.hpp"
#include "fdebench/reports/command/command.hpp"

namespace fde::bench {

// "52 s", "3 min 05 s", "1 h 12 min".
std::string duration_text(double seconds);

// "[#####...............]   25 %  530/2120  2 min 31 s left  pendulum l1 N = 64", truncated to a terminal of
// `columns` columns; without the bar below 60 columns. columns = 0 (no terminal): without the bar, and
// with the current work only where the time left is unknown.
std::string progress_text(const Progress& progress, int columns);

// Nothing is shown before this time.
inline constexpr std::chrono::milliseconds before_progress{2000};

// Shows on a terminal what a command does, in one line of streams.err that appears after `before` and is
// erased by the destructor. With `lines_elsewhere` a line per minute is written where there is no terminal.
// The line also goes on while nothing is set. While an object exists, nothing else may write to streams.err,
// except through interrupt().
class ProgressLine {
 public:
  ProgressLine(const Streams& streams, std::string what, bool lines_elsewhere = false,
               std::chrono::milliseconds before = before_progress);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  // Sets what is shown. The time left follows from the part and the time since `current_run` last changed.
  void set(Progress progress);
  void set(std::size_t done, std::size_t total, const std::string& what);
  // Calls an action that writes to streams.err.
  void interrupt(const std::function<void()>& action);

 private:
  using Clock = std::chrono::steady_clock;
  void show();   // the caller holds the mutex
  void erase();  // likewise

  const Streams& streams_;
  std::mutex mutex_{};  // guards the members below, and streams_.err
  Progress progress_;
  Clock::time_point start_ = Clock::now();
  bool line_is_open_ = false;
  std::condition_variable_any ended_{};
  std::jthread ticks_{};
};

// Shows progress immediately, unless --quiet is given. If total = 0 (unknown), only the current work and the
// steps done.
void show_work(const Streams& streams, std::size_t done, std::size_t total, const std::string& what);

// Shows the progress of a sweep on streams.err. The constructor prints the expected number of runs and the
// expected time if that is more than some seconds; then progress follows, on a terminal in one line after
// `before_progress`, otherwise a line per `between_lines`, also during a longer run. The time in which
// references are computed says nothing of the time left. Silent with --quiet.
class SweepProgress {
 public:
  SweepProgress(const Streams& streams, Forecast expected, bool count_is_exact,
                std::chrono::milliseconds between_lines = std::chrono::minutes(1));
  SweepProgress(const SweepProgress&) = delete;
  SweepProgress& operator=(const SweepProgress&) = delete;
  ~SweepProgress();  // erases the line

  // To be called with every event of the sweep.
  void on_event(const SweepEvent& event);

 private:
  using Clock = std::chrono::steady_clock;
  void show();

  const Streams& streams_;
  std::mutex mutex_{};  // guards the members below
  SweepEstimate remaining_;
  Clock::time_point start_ = Clock::now();  // later by the time in which references were computed
  Clock::time_point shown_ = start_, last_event_ = start_;
  bool line_is_open_ = false;
  std::condition_variable_any ended_{};
  std::jthread lines_{};  // shows the progress of longer runs
};

}  // namespace fde::bench
