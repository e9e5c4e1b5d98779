#pragma once

#include <cstddef>
#include <string>

#include "sweep/forecast.hpp"

namespace fde {

// How far a sweep is, told by its events and the seconds since it began.
class Remaining {
 public:
  explicit Remaining(Forecast forecast);

  void hear(const SweepEvent& event);

  [[nodiscard]] std::size_t runs_done() const { return done_; }
  [[nodiscard]] std::size_t runs_expected() const { return done_ + left_.size(); }

  // Of the whole, by expected seconds: between 0 and 1.
  [[nodiscard]] double part_done() const;

  // What is left, at the pace so far, which counts the more the longer the sweep has gone on.
  [[nodiscard]] double seconds_left(double elapsed) const;

  // The run at hand: "pendulum l1 N = 64", and whether it is timed.
  [[nodiscard]] const std::string& at_hand() const { return at_hand_; }

 private:
  void leave_out(const RunKey& last);

  Forecast left_;
  double seconds_left_, seconds_done_ = 0.0;  // as expected
  std::size_t done_ = 0;
  std::string at_hand_{};
};

}  // namespace fde
