// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

namespace fde::reference {

// The three-parameter Mittag-Leffler function of Prabhakar,
//   E^gamma_{alpha,beta}(z) = sum_k (gamma)_k z^k / (k! Gamma(alpha k + beta)),
// alpha in (0, 5], beta and gamma in [-10000, 10000], complex z; the doubles are taken exactly. Almost
// correctly rounded, like mittag_leffler(). By power series or contours that enclose all singularities, in
// some ten microseconds where double-doubles are accurate enough, otherwise in multiprecision. The
// multiprecision bounds on a contour are a priori bounds except for the part beyond the last node, which has
// the size of the requested accuracy and is estimated. Throws std::invalid_argument naming an argument
// outside its range or not finite, std::runtime_error naming all arguments if the value overflows,
// |Im z^(1/alpha)| is above 1e8, or the digits do not suffice.
MittagLefflerValue prabhakar(double alpha, double beta, double gamma, std::complex<double> z);

// The k-th derivative of E_{alpha,beta} at z, k! E^{k+1}_{alpha,beta + k alpha}(z), for
// 0 <= k <= max_derivative; accuracy and exceptions as for prabhakar().
inline constexpr int max_derivative = 1000;
MittagLefflerValue mittag_leffler_derivative(int k, double alpha, double beta, std::complex<double> z);

// The same to `digits` decimal digits, with decimal texts as arguments, like the mittag_leffler() of texts.
DecimalComplex prabhakar(const std::string& alpha, const std::string& beta, const std::string& gamma,
                         const std::string& re, const std::string& im, int digits);
DecimalComplex mittag_leffler_derivative(int k, const std::string& alpha, const std::string& beta,
                                         const std::string& re, const std::string& im, int digits);

}  // namespace fde::reference
