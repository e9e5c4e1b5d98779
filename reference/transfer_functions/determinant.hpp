#pragma once

#include <vector>

#include "transfer_functions/generalized_polynomial.hpp"

namespace fde {

using PolynomialMatrix = std::vector<std::vector<GeneralizedPolynomial>>;  // rows

// The determinant of a square matrix of sums of powers, exactly, by expansion along the rows with every minor
// made once: quick where rows have few entries. Only one column may have coefficients that are not fractions.
GeneralizedPolynomial determinant(const PolynomialMatrix& matrix);

}  // namespace fde
