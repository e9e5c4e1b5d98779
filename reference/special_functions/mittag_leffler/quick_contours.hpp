// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <complex>
#include <span>

#include "fdebench/reference/special_functions/laplace/contour_bound.hpp"
#include "fdebench/reference/special_functions/laplace/free_strip.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/contour_kernels.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/forms.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/quick.hpp"

// The contours of mittag_leffler_quick(), computed once.
namespace fde::reference {

// A contour with its error bound and its nodes in the form that the kernels take.
struct QuickContour {
  explicit QuickContour(const ContourShape& of);

  ContourShape shape;
  ContourBound bound;
  DoubleDouble half_log_mu;
  ContourNodes nodes;
};

// Two contours with nodes half a step apart, for F = s^exponent / (s^alpha - z) with exponent - alpha (F for
// large s) at least least_exponent and exponent (F for small s) at most most_exponent.
struct QuickContours {
  double least_exponent, most_exponent;
  std::array<QuickContour, 2> staggered;

  [[nodiscard]] bool covers(double least, double most) const {
    return least >= least_exponent && most <= most_exponent;
  }
  // The contour whose nodes are farther from the poles; roots as in ContourBound::Quotient.
  [[nodiscard]] const QuickContour& away_from(std::span<const std::complex<double>> roots) const;
};

// In the order in which they are tried.
const std::array<QuickContours, 6>& quick_contours();

// z = value * 2^exponent with 1 <= |value| < 4, for every z other than 0.
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
  // Whether the pole represents its conjugate as well.
  [[nodiscard]] bool represents_conjugate(const Pole<double>& pole) const;
};

inline std::complex<long double> to_long(const ComplexDoubleDouble& z) {
  return {static_cast<long double>(z.re.hi) + z.re.lo, static_cast<long double>(z.im.hi) + z.im.lo};
}

// The sum of the residues at the poles in `counted`, each times its factor m on the contour (nullptr: 1).
// nullopt where the phase of e^s* is too large to compute for one of them.
std::optional<QuickValue> residue_sum(const QuickArguments& x, const QuickContour* contour,
                                      const PerSheet<Pole<double>>& counted);

// E_{alpha,beta}(z) as a sum of residues, for EvaluationForm::residues_only.
std::optional<QuickValue> sum_of_all_residues(const QuickArguments& x);

// The contours of the quick evaluations for singularities of any kind (SingularityFreeStrip), computed once.
struct ShiftedContour {
  explicit ShiftedContour(const ShiftedShape& of);

  ShiftedShape shape;
  SingularityFreeStrip strip;
  ContourNodes nodes;
};

// Largest accepted logarithm of the discretisation error, relative to the largest possible value.
inline constexpr double max_log_error = -33.0;

// In the order in which they are tried.
const std::array<ShiftedContour, 8>& shifted_contours();

// The singularities s*^alpha = z in the form that SingularityFreeStrip takes.
struct SingularityRoots {
  SingularityRoots(double alpha, const std::complex<double>& log_z, int first_sheet);

  double log_size;
  Poles<double> poles;
  PerSheet<std::complex<double>> roots;

  // max(0, largest Re s* on the principal sheet): the logarithm of the possible size of the function.
  [[nodiscard]] double growth() const;
  [[nodiscard]] SingularityFreeStrip::Factor factor(double singularity_order) const {
    return {log_size, poles.nearest_other_argument, {roots.data(), roots.size()}, singularity_order};
  }
};

}  // namespace fde::reference
