#pragma once

#include <Eigen/LU>

#include "run.hpp"

namespace fde {

// df/dy at y, where f is f(t, y): the linear part or the Jacobian of the problem, or forward differences of
// rhs where it has none.
void differentiate(Run& run, const Problem& problem, double t, In y, In f, OutMatrix jacobian);

// Solves y = past + kappa f(t, y) for y, step after step of one run.
//
// A problem with a linear part A is solved with one factorisation of I - kappa A as long as kappa stays the
// same. Otherwise Newton's method takes the Jacobian of the problem, or differences of rhs where it has none,
// anew in each iteration, until the last increment is below tolerance * |y|, or has stopped to shrink below
// 1e-10 * |y|: there it is rounding.
class NewtonSolver {
 public:
  NewtonSolver(const Problem& problem, double tolerance);

  // Improves the guess y to the solution. False when 50 iterations do not suffice or a value is not finite.
  bool solve(Run& run, double t, const Vec& kappa, In past, Out y);

 private:
  bool solve_linear(Run& run, double t, In past, Out y);
  [[nodiscard]] Matrix system(const Matrix& jacobian) const;  // I - kappa J
  // jacobian_ becomes I - kappa df/dy at y, where f is f(t, y).
  void differentiate(Run& run, double t, In y, In f);

  const Problem& problem_;
  Vec kappa_;
  double tolerance_;
  Matrix jacobian_;
  Eigen::PartialPivLU<Matrix> factors_;  // of the linear part
  Vec f_, increment_;
};

}  // namespace fde
