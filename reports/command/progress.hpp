#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "command/command.hpp"
#include "sweep/remaining.hpp"

namespace fde {

// What is done of a long work.
struct Progress {
  double part = 0.0;  // between 0 and 1
  std::size_t done = 0, total = 0;
  std::optional<double> seconds_left{};
  std::string at_hand{};
};

// "52 s", "3 min 05 s", "1 h 12 min".
std::string duration_text(double seconds);

// "[#####...............]   25 %  530/2120  2 min 31 s left  pendulum l1 N = 64", shorter than a terminal of
// so many columns is wide: the bar is left out below 60, and what does not fit is cut off. 0 columns, of no
// terminal: the same without the bar and the work at hand.
std::string progress_text(const Progress& progress, int columns);

// Shows on err what has been done: on a terminal in one line, elsewhere in a line a minute.
std::function<void(std::size_t done, std::size_t total, const std::string& what)> progress_line(
    const Streams& streams);

// The same at once, for work whose end may not be known: without a total only what is at hand and the steps
// done.
void show_work(const Streams& streams, std::size_t done, std::size_t total, const std::string& what);

// Shows on err how far a sweep is: before it how many runs and how long it is expected to take, where that is
// more than some seconds; then the progress, on a terminal in one line, otherwise in a line a minute, also
// during a run that takes longer.
class SweepProgress {
 public:
  SweepProgress(const Streams& streams, Forecast expected, bool count_is_exact,
                std::chrono::milliseconds between_lines = std::chrono::minutes(1));
  SweepProgress(const SweepProgress&) = delete;
  SweepProgress& operator=(const SweepProgress&) = delete;
  ~SweepProgress();  // ends the line

  void hear(const SweepEvent& event);

 private:
  using Clock = std::chrono::steady_clock;
  void show();

  const Streams& streams_;
  std::mutex mutex_{};  // of what follows
  Remaining remaining_;
  Clock::time_point start_ = Clock::now(), shown_ = start_;
  bool line_is_open_ = false;
  std::condition_variable_any ended_{};
  std::jthread lines_{};  // where there is no terminal
};

}  // namespace fde
