// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>

#include "fdebench/benchmarks/sweep/forecast.hpp"

namespace fde::bench {

// Progress of a sweep, from its events and the elapsed seconds.
class SweepEstimate {
 public:
  explicit SweepEstimate(Forecast forecast);

  // To be called with every event of the sweep.
  void on_event(const SweepEvent& event);

  [[nodiscard]] std::size_t runs_done() const { return done_; }
  [[nodiscard]] std::size_t runs_expected() const { return done_ + left_.size(); }

  // Finished fraction of the sweep in [0, 1], weighted by expected seconds.
  [[nodiscard]] double part_done() const;

  // Expected seconds left: the forecast times the observed ratio of elapsed to forecast time, which gets more
  // weight as the sweep goes on. nullopt while a reference is computed, whose time no forecast knows.
  [[nodiscard]] std::optional<double> seconds_left(double elapsed) const;

  // Whether the reference of a scene is being computed.
  [[nodiscard]] bool seeks_reference() const { return !references_.empty(); }

  // The current run: "pendulum l1 N = 64", with ", time" while it is timed; "computes the reference of
  // pendulum for l1 N = 64" where the examination needs it first.
  [[nodiscard]] const std::string& current_run() const { return at_hand_; }

 private:
  void drop_series(const RunKey& last);

  Forecast left_;
  double seconds_left_, seconds_done_ = 0.0;  // forecast seconds
  std::size_t done_ = 0;
  std::string at_hand_{};
  std::set<SceneSettings> references_{};  // the scenes whose reference is being computed
};

}  // namespace fde::bench
