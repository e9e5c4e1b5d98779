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

#include "fdebench/benchmarks/sweep/sweep_estimate.hpp"
#include "fdebench/reports/command/command.hpp"

namespace fde::bench {

// Progress of a long computation.
struct Progress {
  double part = 0.0;  // finished fraction, in [0, 1]
  std::size_t done = 0, total = 0;
  std::optional<double> seconds_left{};
  std::string current_run{};
};

// "52 s", "3 min 05 s", "1 h 12 min".
std::string duration_text(double seconds);

// "[#####...............]   25 %  530/2120  2 min 31 s left  pendulum l1 N = 64", truncated to a terminal of
// `columns` columns; without the bar below 60 columns. columns = 0 (no terminal): without the bar and the
// current work.
std::string progress_text(const Progress& progress, int columns);

// A callback that shows progress on streams.err: on a terminal in one line, otherwise a line per minute.
std::function<void(std::size_t done, std::size_t total, const std::string& what)> progress_line(
    const Streams& streams);

// Shows progress immediately. If total = 0 (unknown), only the current work and the steps done.
void show_work(const Streams& streams, std::size_t done, std::size_t total, const std::string& what);

// Shows the progress of a sweep on streams.err. The constructor prints the expected number of runs and the
// expected time if that is more than some seconds; then progress follows, on a terminal in one line,
// otherwise a line per `between_lines`, also during a longer run.
class SweepProgress {
 public:
  SweepProgress(const Streams& streams, Forecast expected, bool count_is_exact,
                std::chrono::milliseconds between_lines = std::chrono::minutes(1));
  SweepProgress(const SweepProgress&) = delete;
  SweepProgress& operator=(const SweepProgress&) = delete;
  ~SweepProgress();  // ends the line

  // To be called with every event of the sweep.
  void on_event(const SweepEvent& event);

 private:
  using Clock = std::chrono::steady_clock;
  void show();

  const Streams& streams_;
  std::mutex mutex_{};  // guards the members below
  SweepEstimate remaining_;
  Clock::time_point start_ = Clock::now(), shown_ = start_;
  bool line_is_open_ = false;
  std::condition_variable_any ended_{};
  std::jthread lines_{};  // prints the lines if err is no terminal
};

}  // namespace fde::bench
