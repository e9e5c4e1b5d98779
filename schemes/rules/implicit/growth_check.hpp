// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/rules/implicit/newton_matrix.hpp"

namespace fde {

// Detects steps of a linear problem that are too large for one of its growing modes.
//
// The matrix mass - kappa A of a step is singular where the factor by which a mode e^(st) grows in one step
// is infinite: kappa_i = c_i h^(g_i) = 1 / s^(g_i). With a larger step the computed mode alternates in sign
// or decays: the values are finite and unrelated to the solution. The determinant has then changed its sign.
// Its sign is compared with the signs for smaller steps, from half the step size down to where the matrix is
// diagonally dominant and smaller steps have no zero. With algebraic rows it goes on until the sign is lost
// in rounding. Step sizes between those are not tested, so two modes close to each other cancel.
class GrowthCheck {
 public:
  // Precondition: the problem is linear.
  explicit GrowthCheck(const Problem& problem);

  // Whether the step is too large. Precondition: the matrix is factorised for kappa, with the result
  // `solvable`; it is factorised for kappa again on return.
  bool is_step_too_large(NewtonMatrix& matrix, const Vec& kappa, bool solvable);

  void state(Archive& archive) { archive(largest_accepted_kappa_, accepted_sign_); }

 private:
  // Whether the matrix is diagonally dominant for this kappa, and so for all smaller steps: its determinant
  // has the same sign for all of them.
  [[nodiscard]] bool is_diagonally_dominant(const Vec& kappa) const;

  Vec orders_;
  Vec gershgorin_bound_;        // a_ii + sum_{j != i} |a_ij|; infinity in algebraic rows
  Vec largest_accepted_kappa_;  // kappa of the largest step that was not too large; 0: there was none
  int accepted_sign_ = 0;       // of the determinant for that kappa
};

}  // namespace fde
