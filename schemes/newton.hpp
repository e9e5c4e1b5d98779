#pragma once

#include <Eigen/LU>

#include "run.hpp"

namespace fde {

// df/dy at y, where f is f(t, y): the linear part or the Jacobian of the problem, or forward differences of
// rhs where it has none, for which sizes tells how large the components of y are when they are not 0.
void differentiate(Run& run, const Problem& problem, double t, In y, In f, In sizes, OutMatrix jacobian);

// Solves y_i = past_i + kappa_i f_i(t, y), and 0 = f_i(t, y) in algebraic rows, for y, step after step of one
// run.
//
// A problem with a linear part A is solved with one factorisation of I - kappa A as long as kappa stays the
// same. Otherwise Newton's method takes the Jacobian of the problem, or differences of rhs where it has none,
// anew in each iteration, until the last increment is below tolerance * |y|, or has stopped to shrink below
// 1e-10 * |y|: there it is rounding.
//
// |y| is the largest of the other unknowns where there are algebraic rows. An unknown lambda_i of an
// algebraic row counts as what it does to the equations, max_k |M_ki| |lambda_i| with M the matrix of
// Newton's method, and relative to |y| or, where it is larger, to itself. That is about |lambda_i| where its
// own row determines it. A multiplier, which only enters other rows with kappa, counts with kappa: it is
// known no better than rounding / kappa, and is not asked for more. What the last increment leaves of a
// constraint is of second order in that increment, or rounding.
class NewtonSolver {
 public:
  NewtonSolver(const Problem& problem, double tolerance);

  // Improves the guess y to the solution. False when 50 iterations do not suffice, a value is not finite, or
  // the constraints of a linear problem depend on each other.
  bool solve(Run& run, double t, const Vec& kappa, In past, Out y);

 private:
  bool solve_linear(Run& run, double t, In past, Out y);
  // Newton's method from y on. Given up where increments have not become smaller so many times.
  bool iterate(Run& run, double t, In past, Out y, int most_setbacks);
  // Brings y closer, by pseudo time steps of mass y' = past + kappa f(t, y) - y that end in Newton's method.
  bool approach(Run& run, double t, In past, Out y);
  // matrix_ = mass - kappa df/dy at y, where f_ is f(t, y).
  void differentiate(Run& run, double t, In past, In y);
  // The same in place of df/dy = matrix_. Algebraic rows get the factor that makes their largest entry 1.
  void assemble();
  // Of the linear part. A matrix of constraints that depend on each other has none, however they round.
  void factorise();
  // The largest of the last increments relative to |y|, as above.
  [[nodiscard]] double relative_increment(In y) const;
  // increment_ becomes what is left of the equations, where f_ is f(t, y).
  void take_residual(In past, In y) {
    increment_ = past + kappa_.cwiseProduct(f_) - y;
    for (const auto i : algebraic_) increment_[i] = kappa_[i] * f_[i];
  }

  const Problem& problem_;
  std::vector<Eigen::Index> algebraic_;  // rows
  Vec mass_;                             // of y in each row: 0 in algebraic rows, 1 in others
  Vec given_kappa_, kappa_;              // the latter with the factors of algebraic rows
  double tolerance_;
  Matrix matrix_;
  Eigen::PartialPivLU<Matrix> factors_;  // of the linear part
  bool singular_ = false;
  Vec f_, increment_;
};

}  // namespace fde
