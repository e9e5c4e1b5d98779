// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The equations of one step of an implicit rule: y_i = known_i + kappa_i f_i(t, y), and 0 = f_i(t, y) in
// algebraic rows. known is the part that does not depend on y: the Taylor part and the memory term. kappa is
// the weight of f(t, y). Where f jumps at t, before_jump is a time just before t (GridJumps).
struct StepEquations {
  double t;
  const Vec& kappa;
  const Vec& known;
  std::optional<double> before_jump{};
};

// Scales of the rows of these equations in Newton's method: row i reads
//   0 = mass_i (known_i - y_i) + scale_i f_i(t, y).
struct RowScales {
  explicit RowScales(const Problem& problem);

  std::vector<Eigen::Index> algebraic;
  Vec mass;    // 1, and 0 in algebraic rows
  Vec scale;   // kappa; in algebraic rows 1 / max_j |df_i/dy_j|
  Vec weight;  // of unknowns: 1; of algebraic rows their effect on the equations, max_k |M_ki| with M the
               // iteration matrix

  void state(Archive& archive) { archive(scale, weight); }
};

// Sets rest to the residual of the scaled equations at y. f: f(t, y).
void compute_residual(const StepEquations& step, const RowScales& rows, In f, In y, Out rest);

// Whether known + part = y, part = kappa f, holds to the tolerance, relative to the two terms.
inline bool equation_holds(double known, double part, double y, double tolerance) {
  const double terms = std::abs(known) + std::abs(part);
  return std::abs(known + part - y) <= tolerance * terms && std::isfinite(terms);
}

// Whether each equation holds to the tolerance. Precondition: no row is algebraic.
bool equations_hold(const StepEquations& step, In f, In y, double tolerance);

// The largest increment relative to |y|, both measured as described at NewtonSolver.
double relative_norm(const RowScales& rows, In increment, In y);

}  // namespace fde
