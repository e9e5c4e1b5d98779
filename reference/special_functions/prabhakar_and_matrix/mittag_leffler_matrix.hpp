// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

namespace fde::reference {

// A matrix with a bound of the error of each entry.
struct MatrixValue {
  Eigen::MatrixXcd value;
  Eigen::MatrixXd bound;
};

// The Mittag-Leffler function of a square matrix, defective ones included,
//   E_{alpha,beta}(A) = sum_k A^k / Gamma(alpha k + beta)
//                     = 1/(2 pi i) int e^s s^(alpha-beta) (s^alpha - A)^-1 ds,
// alpha in (0, 5], real |beta| <= 10000, 1 to 64 rows; the doubles are taken exactly. Every entry is almost
// correctly rounded; an entry 40 digits smaller than its summands, as where they cancel, counts as 0. Up to 4
// rows take some ten microseconds where double-doubles are accurate enough. Otherwise, in multiprecision, the
// bounds follow from norms of the resolvent and need no diagonalisation, with two exceptions: that the
// contour encloses all eigenvalues relies on eigenvalues computed to 60 digits or more, and the part beyond
// the last node is estimated. Throws std::invalid_argument naming an argument outside its range;
// std::runtime_error if an entry overflows, the digits do not suffice, or |Im lambda^(1/alpha)| is above 1e8
// for an eigenvalue.
MatrixValue mittag_leffler(double alpha, double beta, const Eigen::MatrixXcd& matrix);
MatrixValue mittag_leffler(double alpha, double beta, const Eigen::MatrixXd& matrix);

// The same in decimal, like the mittag_leffler() of decimal numbers. Entries row by row;
// DecimalComplex::bound of the arguments is ignored.
std::vector<DecimalComplex> mittag_leffler(const std::string& alpha, const std::string& beta,
                                           const std::vector<DecimalComplex>& matrix, int digits);

}  // namespace fde::reference
