#pragma once

#include <vector>

#include "checkpoint/archive.hpp"
#include "problem/problem.hpp"

namespace fde {

// The equations of one step of an implicit rule: y_i = past_i + kappa_i f_i(t, y), and 0 = f_i(t, y) in
// algebraic rows.
struct StepEquations {
  double t;
  const Vec& kappa;
  const Vec& past;
};

// How the rows of these equations are scaled where they are solved together: row i reads
//   0 = mass_i (past_i - y_i) + scale_i f_i(t, y).
struct RowScales {
  explicit RowScales(const Problem& problem);

  std::vector<Eigen::Index> algebraic;
  Vec mass;    // 1, and 0 in algebraic rows
  Vec scale;   // kappa; in algebraic rows what makes the largest df_i/dy_j 1
  Vec weight;  // of unknowns: 1; of algebraic rows what moving them does to the equations, max_k |M_ki| with
               // M the matrix of Newton's method

  void state(Archive& archive) { archive(scale, weight); }
};

// rest becomes what y leaves of the equations, where f is f(t, y).
void take_residual(const StepEquations& step, const RowScales& rows, In f, In y, Out rest);

// Whether each equation holds to the tolerance, relative to its own terms past_i and kappa_i f_i. No row is
// algebraic.
bool holds(const StepEquations& step, In f, In y, double tolerance);

// The largest increment relative to |y|, both as Newton's method takes them (newton.hpp).
double relative_size(const RowScales& rows, In increment, In y);

}  // namespace fde
