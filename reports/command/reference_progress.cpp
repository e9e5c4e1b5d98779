// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/reference_progress.hpp"

#include <fmt/format.h>

#include <ostream>
#include <utility>

#include "fdebench/reports/command/progress_display.hpp"

namespace fde::bench {

ReferenceProgress::ReferenceProgress(const Streams& streams, std::optional<double> budget, std::string sought)
    : streams_(streams),
      budget_(budget),
      sought_(std::move(sought)),
      listening_([this](std::size_t done, std::size_t total) { on_progress(done, total); }) {}

ReferenceProgress::~ReferenceProgress() {
  if (line_is_open_) streams_.err << fmt::format("\r{:{}}\r", "", streams_.columns - 1);
}

void ReferenceProgress::fail() const {
  throw NumericalFailure(fmt::format("the budget of {:g} s ran out before {} was known{}", *budget_, sought_,
                                     place_.empty() ? "" : " at " + place_));
}

void ReferenceProgress::on_progress(std::size_t done, std::size_t total) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (budget_ && std::chrono::duration<double>(now - start_).count() > *budget_) throw Cancelled();
  const bool terminal = streams_.columns > 0;
  if (streams_.quiet) return;
  if (terminal ? now - start_ < before_progress || now - shown_ < 100ms : now - shown_ < 1min) return;
  shown_ = now;
  line_is_open_ = terminal;
  show_work(streams_, done, total, place_);
}

}  // namespace fde::bench
