#pragma once

#include <complex>
#include <string>

#include "reference.hpp"

namespace fde {

struct MittagLefflerValue {
  std::complex<double> value;
  double bound;  // of |error|
};

// E_{alpha,beta}(z) = sum_k z^k / Gamma(alpha k + beta), alpha in (0, 5], real beta of at most 10000, complex
// z, each taken for the double it is. The bound is at most 7 ulp of |E|, or near a zero of |z E'|, and nearly
// always half an ulp; Inf where the value overflows, never NaN. A microsecond or two, unless more digits are
// needed (then milliseconds). Throws std::invalid_argument naming the argument when alpha is outside (0, 5]
// or an argument is not finite.
MittagLefflerValue mittag_leffler(double alpha, double beta, std::complex<double> z);
double mittag_leffler(double alpha, double beta, double z);

// The same to a number of decimal digits; the arguments are decimal texts, taken exactly ("0.1" is one
// tenth). The bound is of |error| and includes the rounding of the texts.
struct DecimalComplex {
  std::string re, im, bound;
};
DecimalComplex mittag_leffler(const std::string& alpha, const std::string& beta, const std::string& re,
                              const std::string& im, int digits);

// The same rounded to double. Where all texts name doubles this is the function of these, in microseconds.
MittagLefflerValue mittag_leffler_in_double(const std::string& alpha, const std::string& beta,
                                            const std::string& re, const std::string& im);

}  // namespace fde
