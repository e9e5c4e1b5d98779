// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/nonlinear/collocation/panels.hpp"
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
// where no panel converges or too many are needed, Singularity where y leaves problem.domain.
class PiecewiseSolution {
 public:
  // The problem and options.looking_back, which then looks back at this object, must outlive it.
  PiecewiseSolution(const Problem& problem, const PanelOptions& options);

  PiecewiseSolution& operator=(PiecewiseSolution&&) = delete;

  [[nodiscard]] Vec at(double t) const;                // 0 <= t <= end
  [[nodiscard]] std::size_t panel_of(double t) const;  // the panel that ends at or after t
  [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
  [[nodiscard]] const PanelBasis& basis() const { return basis_; }
  // The time up to which f and y are not required to be resolved.
  [[nodiscard]] double unresolved_until() const { return negligible_before_; }
  // Whether the panel is long enough, and so long after a jump, that f and y were required to be resolved.
  [[nodiscard]] bool is_resolved(const Panel& panel) const;
  // y at the start of a panel, at the Gauss-Legendre points and at its end: values that determine the
  // polynomial.
  [[nodiscard]] Matrix legendre_values(const Panel& panel) const;

 private:
  const Problem& problem_;
  double negligible_before_;  // absolute
  PanelBasis basis_;
  std::vector<Panel> panels_;
  Vec kept_;  // the points of legendre_values
};

}  // namespace fde::reference
