// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/reference/nonlinear/collocation/piecewise_solution.hpp"
#include "fdebench/reference/nonlinear/diffusive/diffusive_solution.hpp"

namespace fde::reference {

// The times about events that set unknowns, at which it is not known whether y has jumped: each run has its
// own time of an event. The window of an event contains these times and is three times as long as the part
// between them. An event whose function depends on t alone has none: y is as before up to its time, for every
// run.
class EventWindows {
 public:
  // The events of the runs, which are runs of the same problem. Throws std::runtime_error naming the time
  // where an event of one is none of another, unless it is next to the end, and where the times of an event
  // differ by more than a thousandth of the time since the event before.
  EventWindows(const PiecewiseSolution& solution, const PiecewiseSolution& other,
               const DiffusiveSolution& second);

  [[nodiscard]] bool contains(double t) const;

  // Whether a window begins between these times, and where.
  [[nodiscard]] std::optional<double> beginning(double from, double to) const;

  // What y may jump by within [from, to]: 0 outside of all windows.
  [[nodiscard]] Vec jump_within(double from, double to) const;

 private:
  struct Window {
    double from, to;
    Vec jump;
  };
  Eigen::Index size_;
  std::vector<Window> windows_{};  // increasing
};

}  // namespace fde::reference
