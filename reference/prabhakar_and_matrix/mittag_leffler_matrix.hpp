#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mittag_leffler/mittag_leffler.hpp"
#include "problem/problem.hpp"

namespace fde {

// A matrix with a bound of the error of each entry.
struct MatrixValue {
  ComplexMatrix value;
  Eigen::MatrixXd bound;
};

// The Mittag-Leffler function of a square matrix, defective ones included,
//   E_{alpha,beta}(A) = sum_k A^k / Gamma(alpha k + beta)
//                     = 1/(2 pi i) int e^s s^(alpha-beta) (s^alpha - A)^-1 ds,
// alpha in (0, 5], real beta, up to 64 rows; arguments are taken for the doubles they are. Every entry is
// almost correctly rounded; an entry 40 digits smaller than the integrand counts as 0. Up to 4 rows take some
// ten microseconds where double-doubles are enough. Else, in multiprecision, the bounds are
// computed from norms of the resolvent and need no diagonalisation, but that the contour encloses all
// eigenvalues rests on eigenvalues computed to 60 digits and more, and the part beyond the last node is an
// estimate. Throws std::invalid_argument naming the argument; std::runtime_error when an entry overflows, no
// digits in reach make it accurate, or eigenvalues are so large that the contour has too many nodes.
MatrixValue mittag_leffler(double alpha, double beta, const ComplexMatrix& matrix);
MatrixValue mittag_leffler(double alpha, double beta, const Eigen::MatrixXd& matrix);

// The same in decimal, as mittag_leffler() of a number has it. Row by row; bounds of the arguments are not
// read.
std::vector<DecimalComplex> mittag_leffler(const std::string& alpha, const std::string& beta,
                                           const std::vector<DecimalComplex>& matrix, int digits);

}  // namespace fde
