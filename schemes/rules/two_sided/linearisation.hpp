// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/rules/two_sided/global_equations.hpp"

namespace fde {

// Newton's linear equations at all times at once. With J_n = df/dy at t_n, K the rules of both sides, B the
// terms of the unknown initial values p and C the derivatives of the conditions with respect to y(0) and
// y(end):
//   x - K J x - B p = r,    C x = c,
// without the x in algebraic rows.
class Linearisation {
 public:
  // The equations must outlive this object.
  explicit Linearisation(const GlobalEquations& equations) : equations_(equations) {}

  // Computes the Jacobians at a guess with this residual.
  void update(Run& run, const GridFunction& guess, const Residual& residual);

  // The left-hand sides for x and p.
  struct LeftHandSides {
    Rows rows;
    Vec conditions;
  };
  [[nodiscard]] LeftHandSides left_hand_sides(const GridFunction& x) const;

  // Replaces y by the solution of y = given + K J y, one side after the other: first the left rows, with the
  // right rows of the y that is passed, then the right rows.
  void forward_backward_sweep(const Rows& given, Rows& y) const;
  // The solution y of the diagonal blocks: without coupling between different times or between the two sides.
  [[nodiscard]] Rows block_diagonal_solution(const Rows& given) const;
  [[nodiscard]] Vec conditions(const Rows& y) const;  // C y
  [[nodiscard]] const Matrix& conditions_by_start() const { return by_start_; }
  [[nodiscard]] const Matrix& conditions_by_end() const { return by_end_; }
  // df/dy at the n-th time.
  [[nodiscard]] Eigen::Map<const Matrix> jacobian(Eigen::Index n) const;

  [[nodiscard]] const GlobalEquations& equations() const { return equations_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  void differentiate_conditions(const GridFunction& guess, const Vec& conditions);

  const GlobalEquations& equations_;
  Matrix jacobians_;  // one column a time, or one for all
  Matrix left_inverses_, right_inverses_;
  Matrix by_start_, by_end_;  // derivatives of the conditions
};

}  // namespace fde
