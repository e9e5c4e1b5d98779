// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "fdebench/reports/command/command.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::bench {

// Monitors evaluations of references while the object exists: shows progress on streams.err (on a terminal
// after two seconds in one line, otherwise a line per minute, with --quiet nothing) and cancels them with
// Cancelled when the budget is spent.
class ReferenceProgress {
 public:
  // sought: name of the evaluated quantity in messages, "the reference".
  ReferenceProgress(const Streams& streams, std::optional<double> budget, std::string sought);
  ReferenceProgress(const ReferenceProgress&) = delete;
  ReferenceProgress& operator=(const ReferenceProgress&) = delete;
  ~ReferenceProgress();  // erases the progress line

  // Sets the place of the following evaluations for messages, "t = 1".
  void set_place(std::string place) { place_ = std::move(place); }
  // Throws NumericalFailure: the budget ran out, at which place.
  [[noreturn]] void fail() const;

 private:
  using Clock = std::chrono::steady_clock;
  void on_progress(std::size_t done, std::size_t total);

  const Streams& streams_;
  std::optional<double> budget_;
  std::string sought_, place_{};
  Clock::time_point start_ = Clock::now(), shown_ = start_;
  bool line_is_open_ = false;
  ProgressScope listening_;
};

}  // namespace fde::bench
