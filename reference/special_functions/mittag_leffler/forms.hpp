// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/numbers/double_double.hpp"

// The cases in the evaluation of E_{alpha,beta}(z), the inverse Laplace transform at time 1 of
//   F(s) = s^(alpha-beta) / (s^alpha - z),
// for every number type.
namespace fde::reference {

enum class EvaluationForm {
  at_zero,        // z = 0: 1 / Gamma(beta)
  residues_only,  // all powers of s in F are integers: no branch cut, only residues
  shifted_beta,   // 1 / Gamma(beta) = 0, the first term of the series: z E_{alpha,alpha+beta}(z) cancels less
  on_contour      // a contour around the cut, and the residues of the poles outside it
};

// For large |z| the first terms of the asymptotic expansion may be split off ("peeled"), which is exact:
//   E_{alpha,beta}(z) = -sum_{k=1}^m z^-k / Gamma(beta - alpha k) + z^-m E_{alpha,beta-m alpha}(z).

inline bool is_integer(const DoubleDouble& x) { return x.lo == 0.0 && std::floor(x.hi) == x.hi; }
inline double leading_part(const DoubleDouble& x) { return x.hi; }
inline const BigReal& leading_part(const BigReal& x) { return x; }

template <class Real>
bool is_pole_of_gamma(const Real& x) {
  return leading_part(x) <= 0 && is_integer(x);
}

template <class Alpha, class Beta, class Argument>
EvaluationForm evaluation_form(const Alpha& alpha, const Beta& beta, const Argument& z) {
  if (z == Argument(0)) return EvaluationForm::at_zero;
  if (is_integer(alpha) && is_integer(beta) && leading_part(beta) <= alpha)
    return EvaluationForm::residues_only;
  return is_pole_of_gamma(beta) ? EvaluationForm::shifted_beta : EvaluationForm::on_contour;
}

}  // namespace fde::reference
