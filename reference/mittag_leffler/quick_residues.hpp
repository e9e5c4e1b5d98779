#pragma once

#include "mittag_leffler/poles.hpp"
#include "mittag_leffler/quick.hpp"
#include "mittag_leffler/quick_contours.hpp"

namespace fde {

// z = scaled * 2^exponent with 1 <= |scaled| < 4; |z| may be as small or large as a double can be.
struct ScaledArgument {
  std::complex<double> value;
  int exponent;
  ComplexDoubleDouble log;  // of z

  explicit ScaledArgument(std::complex<double> z);
};

// Arguments of E_{alpha,beta}(z), z other than 0, and the poles of its transform.
struct QuickArguments {
  double alpha;
  DoubleDouble beta;
  std::complex<double> z;
  ScaledArgument scaled;
  Poles<double> poles;  // for real z one of each conjugate pair

  QuickArguments(double order, const DoubleDouble& parameter, std::complex<double> argument);

  [[nodiscard]] bool real() const { return z.imag() == 0.0; }
  // log|z|
  [[nodiscard]] double log_size() const { return scaled.log.re.hi; }
  // The pole stands for its conjugate as well.
  [[nodiscard]] bool is_paired(const Pole<double>& pole) const;
};

inline std::complex<long double> to_long(const ComplexDoubleDouble& z) {
  return {static_cast<long double>(z.re.hi) + z.re.lo, static_cast<long double>(z.im.hi) + z.im.lo};
}

// The sum of residues of the poles that are counted, each times its factor on the contour (nullptr: 1). Empty
// where the phase of e^s* is not to be had for one of them.
std::optional<QuickValue> residue_sum(const QuickArguments& x, const QuickContour* contour,
                                      const EachSheet<Pole<double>>& counted);

// E_{alpha,beta}(z) where that is all there is of it (Form::residues_only).
std::optional<QuickValue> from_residues_only(const QuickArguments& x);

}  // namespace fde
