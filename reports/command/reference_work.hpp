#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "command/command.hpp"
#include "progress/work.hpp"

namespace fde {

// Listens to evaluations while it lives: shows on err how far they are, on a terminal after a second in one
// line, otherwise in a line a minute, and ends them with WorkEnded when the budget is spent.
class ReferenceWork {
 public:
  // sought: what is evaluated, "the reference".
  ReferenceWork(const Streams& streams, std::optional<double> budget, std::string sought);
  ReferenceWork(const ReferenceWork&) = delete;
  ReferenceWork& operator=(const ReferenceWork&) = delete;
  ~ReferenceWork();  // takes the line away

  // Evaluations from now on are for this, "t = 1".
  void begin(std::string place) { place_ = std::move(place); }
  // Throws NumericalFailure: what ran out, and where.
  [[noreturn]] void fail() const;

 private:
  using Clock = std::chrono::steady_clock;
  void hear(std::size_t done, std::size_t total);

  const Streams& streams_;
  std::optional<double> budget_;
  std::string sought_, place_{};
  Clock::time_point start_ = Clock::now(), shown_ = start_;
  bool line_is_open_ = false;
  ListeningToWork listening_;
};

}  // namespace fde
