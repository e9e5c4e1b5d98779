// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/laplace/enclosed_transform.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/big_matrix.hpp"

namespace fde::reference {

// The evaluation of s^(alpha-beta) (s^alpha - A)^-1 at the current precision: with the adjugate
//   (x - A)^-1 = sum_j x^j N_j / p(x),  x = s^alpha,
// there is one sum over the nodes for each power x^j, and the matrix is computed once from these sums. The
// scale of an entry is that of products of three factors, f(A), A or the identity, and f(A).
EnclosedTransform::Evaluation resolvent_sums(const BigReal& alpha, const BigReal& beta,
                                             const BigMatrix& matrix);

}  // namespace fde::reference
