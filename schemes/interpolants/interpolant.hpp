#pragma once

#include "stepping/run.hpp"

namespace fde {

// A function through the values of y at the times of a grid, of which a rule takes the Caputo derivative of
// each component i at t* = t_(n-1) + offset_i (t_n - t_(n-1)):
//   D^g_i y_i(t*) = known_i + newest_i (y_n - y_(n-1))_i.
class Interpolant {
 public:
  Interpolant() = default;
  Interpolant(const Interpolant&) = delete;
  Interpolant& operator=(const Interpolant&) = delete;
  virtual ~Interpolant() = default;

  [[nodiscard]] virtual Vec offsets() const = 0;

  // What step n sees, after the increments of those before it.
  virtual void derivative(int n, Out known, Out newest) = 0;

  // Takes in y_n - y_(n-1), of every step but the last, which nothing follows.
  virtual void push(int n, In increment) = 0;

  [[nodiscard]] virtual std::size_t bytes() const = 0;

  // What it keeps of the increments.
  virtual void state(Archive& archive) = 0;
};

// Steps along the grid with D^g_i y_i = f_i, both at t*, y* on the line from y_(n-1) to y_n. Each step is
// solved by Newton's method. No row is algebraic.
Trajectory solve_with(Interpolant& interpolant, const Problem& problem, const Grid& grid,
                      const Options& options);

}  // namespace fde
