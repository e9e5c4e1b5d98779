#pragma once

#include <chrono>
#include <optional>

#include "command/command.hpp"
#include "progress/work.hpp"

namespace fde {

// Listens to references that are evaluated while it lives: shows on err how far they are, on a terminal and
// after a second, and ends them with WorkEnded when the budget is spent.
class ReferenceWork {
 public:
  ReferenceWork(const Streams& streams, std::optional<double> budget);
  ReferenceWork(const ReferenceWork&) = delete;
  ReferenceWork& operator=(const ReferenceWork&) = delete;
  ~ReferenceWork();  // takes the line away

  // Evaluations from now on are for this time.
  void begin(double t) { time_ = t; }
  // Throws NumericalFailure: what ran out, and where.
  [[noreturn]] void fail() const;

 private:
  using Clock = std::chrono::steady_clock;
  void hear(std::size_t done, std::size_t total);

  const Streams& streams_;
  std::optional<double> budget_;
  double time_ = 0.0;
  Clock::time_point start_ = Clock::now(), shown_ = start_;
  bool line_is_open_ = false;
  ListeningToWork listening_;
};

}  // namespace fde
