#pragma once

#include "mittag_leffler/mittag_leffler.hpp"

namespace fde {

// The three-parameter Mittag-Leffler function of Prabhakar,
//   E^gamma_{alpha,beta}(z) = sum_k (gamma)_k z^k / (k! Gamma(alpha k + beta)),
// alpha in (0, 5], beta and gamma in [-10000, 10000], complex z, each taken for the double it is. Almost
// correctly rounded, as mittag_leffler() is. By power series or one contour that encloses all singularities,
// in some ten microseconds where double-doubles are enough, else in multiprecision. Bounds there from the
// contour are theory but for its part beyond the last node, of the size of what was asked for, which is an
// estimate. Throws std::invalid_argument naming the argument when it is outside its range or not finite,
// std::runtime_error naming them all when the value overflows, z^(1/alpha) is too far from the real axis
// (about 1e5), or no digits in reach make it accurate.
MittagLefflerValue prabhakar(double alpha, double beta, double gamma, std::complex<double> z);

// The k-th derivative of E_{alpha,beta} at z, k! E^{k+1}_{alpha,beta + k alpha}(z), for 0 <= k <=
// most_derivatives; otherwise as prabhakar().
inline constexpr int most_derivatives = 1000;
MittagLefflerValue mittag_leffler_derivative(int k, double alpha, double beta, std::complex<double> z);

// The same to a number of decimal digits, as mittag_leffler() has it: the arguments are decimal texts.
DecimalComplex prabhakar(const std::string& alpha, const std::string& beta, const std::string& gamma,
                         const std::string& re, const std::string& im, int digits);
DecimalComplex mittag_leffler_derivative(int k, const std::string& alpha, const std::string& beta,
                                         const std::string& re, const std::string& im, int digits);

}  // namespace fde
