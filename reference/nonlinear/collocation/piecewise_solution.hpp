// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/reference/nonlinear/collocation/panels.hpp"
#include "fdebench/reference/nonlinear/march/reset_locator.hpp"
#include "fdebench/schemes/problem/delays.hpp"

namespace fde::reference {

struct PanelOptions {
  int points;               // Gauss points of a panel
  double first_panel;       // its length relative to the end; its error at a weak singularity decays later
  double first_after_jump;  // the same after a jump of f, relative to the time of the jump
  double tolerance;  // of the last Legendre coefficients of f and y on a panel, relative to their sizes
  // Relative to the end: errors of f before this time are below rounding later.
  double negligible_before = 1e-18;
  // The problem, which looks back at this solution; nullptr: it has no delays.
  BoundProblem* looking_back = nullptr;
};

// The collocation solution of a problem: y is a polynomial on each panel. The length of the panels adapts to
// f and y and at most doubles, so that they are graded towards 0. Throws std::runtime_error naming the time
// where no panel converges or too many are needed, or beyond ResetLocator::most_events, Singularity where y
// leaves problem.domain.
//
// Where an event sets y, located on the polynomials, a panel ends and y jumps.
class PiecewiseSolution {
 public:
  // options.looking_back, which then looks back at this object, must outlive it.
  PiecewiseSolution(const Problem& problem, const PanelOptions& options);

  PiecewiseSolution& operator=(PiecewiseSolution&&) = delete;

  // The problem, with the times of the events that set y among its jump times; these events.
  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const std::vector<ResetEvent>& events() const { return events_; }
  // ResetLocator::next_to at the end.
  [[nodiscard]] const std::optional<ResetEvent>& event_at_end() const { return event_at_end_; }

  [[nodiscard]] Vec at(double t) const;                // 0 <= t <= end; at an event before y jumps
  [[nodiscard]] std::size_t panel_of(double t) const;  // the panel that ends at or after t
  [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
  [[nodiscard]] const PanelBasis& basis() const { return basis_; }
  // The time up to which f and y are not required to be resolved.
  [[nodiscard]] double unresolved_until() const { return negligible_before_; }
  // Whether the panel is long enough, and so long after a jump, that f and y were required to be resolved.
  [[nodiscard]] bool is_resolved(const Panel& panel) const;
  // y at the start of a part [from, to] of a panel, at the Gauss-Legendre points and at its end: values that
  // determine the polynomial.
  [[nodiscard]] Matrix legendre_values(const Panel& panel, double from, double to) const;

 private:
  Problem problem_;
  double negligible_before_;  // absolute
  PanelBasis basis_;
  std::vector<ResetEvent> events_{};
  std::optional<ResetEvent> event_at_end_{};
  std::vector<Panel> panels_;
  Vec kept_;  // the points of legendre_values
};

}  // namespace fde::reference
