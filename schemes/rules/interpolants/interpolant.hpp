// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// An interpolant of y on a grid, whose Caputo derivative a rule evaluates, for each component i, at
// t* = t_(n-1) + offset_i (t_n - t_(n-1)):
//   D^g_i y_i(t*) = known_i + newest_i (y_n - y_(n-1))_i.
class Interpolant {
 public:
  Interpolant() = default;
  Interpolant(const Interpolant&) = delete;
  Interpolant& operator=(const Interpolant&) = delete;
  virtual ~Interpolant() = default;

  [[nodiscard]] virtual Vec offsets() const = 0;

  // The coefficients `known` and `newest` of step n. Precondition: push was called for all earlier steps.
  virtual void derivative(int n, Out known, Out newest) = 0;

  // Appends the increment y_n - y_(n-1). Not needed after the last step.
  virtual void push(int n, In increment) = 0;

  [[nodiscard]] virtual std::size_t bytes() const = 0;
  [[nodiscard]] virtual HistoryKind history_kind() const = 0;

  // Archives the state that depends on the increments.
  virtual void state(Archive& archive) = 0;
};

// Solves D^g_i y_i(t*) = f_i(t*, y*) at every step of the grid, y* on the line from y_(n-1) to y_n, by
// Newton's method. Precondition: no row is algebraic.
Trajectory solve_with_interpolant(Interpolant& interpolant, const Problem& problem, const Grid& grid,
                                  const Options& options);

}  // namespace fde
