// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <string>

namespace fde::reference {

struct MittagLefflerValue {
  std::complex<double> value;
  double bound;  // of |error|
};

// The largest |beta|, and the most digits that can be requested.
inline constexpr int largest_parameter = 10'000, max_digits = 100'000;

// E_{alpha,beta}(z) = sum_k z^k / Gamma(alpha k + beta), alpha in (0, 5], real |beta| <= 10000, complex z;
// the doubles are taken exactly. The bound is at most 7 ulp of |E| (near a zero, of |z E'|) and nearly always
// half an ulp; Inf where the value overflows, never NaN. Takes one or two microseconds, or milliseconds where
// more digits are needed. Throws std::invalid_argument naming the argument if alpha or beta is outside its
// range or an argument is not finite, std::runtime_error where the value overflows and its phase cannot be
// computed.
MittagLefflerValue mittag_leffler(double alpha, double beta, std::complex<double> z);
double mittag_leffler(double alpha, double beta, double z);

// The same for z = re + i im to `digits` decimal digits; the arguments are decimal texts, taken exactly
// ("0.1" is one tenth). The bound is of |error| and includes the rounding of the texts. Throws
// std::invalid_argument also for text that is no number and for digits outside [1, max_digits].
struct DecimalComplex {
  std::string re, im, bound;
};
DecimalComplex mittag_leffler(const std::string& alpha, const std::string& beta, const std::string& re,
                              const std::string& im, int digits);

// The same rounded to double. Where every text is exactly a double, the first overload, in microseconds.
MittagLefflerValue mittag_leffler_in_double(const std::string& alpha, const std::string& beta,
                                            const std::string& re, const std::string& im);

}  // namespace fde::reference
