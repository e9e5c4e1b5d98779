#include "command/reference_work.hpp"

#include <fmt/format.h>

#include <ostream>

#include "command/progress.hpp"

namespace fde {

ReferenceWork::ReferenceWork(const Streams& streams, std::optional<double> budget)
    : streams_(streams),
      budget_(budget),
      listening_([this](std::size_t done, std::size_t total) { hear(done, total); }) {}

ReferenceWork::~ReferenceWork() {
  if (line_is_open_) streams_.err << fmt::format("\r{:{}}\r", "", streams_.columns - 1);
}

void ReferenceWork::fail() const {
  throw NumericalFailure(
      fmt::format("the budget of {:g} s ran out before the reference was known at t = {}", *budget_, time_));
}

void ReferenceWork::hear(std::size_t done, std::size_t total) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (budget_ && std::chrono::duration<double>(now - start_).count() > *budget_) throw WorkEnded();
  if (streams_.columns == 0 || now - start_ < 1s || now - shown_ < 100ms) return;
  shown_ = now;
  line_is_open_ = true;
  show_work(streams_, done, total, fmt::format("t = {}", time_));
}

}  // namespace fde
