// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sweep_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace fde::bench {

SweepEstimate::SweepEstimate(Forecast forecast)
    : left_(std::move(forecast)), seconds_left_(total_seconds(left_)) {}

void SweepEstimate::on_event(const SweepEvent& event) {
  references_.erase(event.run.scene);
  switch (event.kind) {
    case SweepEvent::Kind::examines:
    case SweepEvent::Kind::times:
      if (event.with_reference) references_.insert(event.run.scene);
      at_hand_ = fmt::format("{}{}{} {} {}{}", event.with_reference ? "computes the reference of " : "",
                             label_of(event.run.scene), event.with_reference ? " for" : "", event.run.scheme,
                             resolution_text(event.run.settings),
                             event.kind == SweepEvent::Kind::times ? ", time" : "");
      return;
    case SweepEvent::Kind::is_done: {
      ++done_;
      const auto run = left_.find(event.run);
      if (run == left_.end()) return;
      seconds_done_ += run->second.total();
      seconds_left_ -= run->second.total();
      left_.erase(run);
      return;
    }
    case SweepEvent::Kind::refinement_ends:
      return drop_series(event.run);
  }
}

// Removes the runs that were forecast but are not made, because the refinement has ended. Runs are ordered by
// scene, scheme and resolution.
void SweepEstimate::drop_series(const RunKey& last) {
  auto run = left_.lower_bound({.scene = last.scene,
                                .scheme = last.scheme,
                                .settings = {.resolution = std::numeric_limits<int>::lowest()}});
  while (run != left_.end() && run->first.scene == last.scene && run->first.scheme == last.scheme) {
    if (same_series(run->first.settings, last.settings)) {
      seconds_left_ -= run->second.total();
      run = left_.erase(run);
    } else {
      ++run;
    }
  }
}

double SweepEstimate::part_done() const {
  const double left = std::max(0.0, seconds_left_), whole = seconds_done_ + left;
  return whole > 0.0 ? seconds_done_ / whole : 1.0;
}

std::optional<double> SweepEstimate::seconds_left(double elapsed) const {
  if (seeks_reference()) return {};
  constexpr double trusted = 10.0;  // seconds; the weight of the forecast against the observed pace
  return std::max(0.0, seconds_left_) * (elapsed + trusted) / (seconds_done_ + trusted);
}

}  // namespace fde::bench
