// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/linear/transfer_functions/generalized_polynomial.hpp"

namespace fde::reference {

using PolynomialMatrix = std::vector<std::vector<GeneralizedPolynomial>>;  // rows

// The exact determinant of a square matrix of sums of powers, by expansion along the rows with every minor
// computed once: fast for sparse rows. Precondition: only one column has coefficients that are not rational.
GeneralizedPolynomial determinant(const PolynomialMatrix& matrix);

}  // namespace fde::reference
