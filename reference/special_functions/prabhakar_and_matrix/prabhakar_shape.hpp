// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar_transform.hpp"

namespace fde::reference {

// Properties of Prabhakar's transform for which long double suffices: its singularities, the form in which to
// evaluate it, and a bound of its size. z may overflow in long double.
struct PrabhakarSingularities {
  using Point = EnclosingContour::Point;

  // Precondition: a Precision of 120 digits is in force. Sums of the arguments that are integers up to 1e-100
  // count as integers.
  explicit PrabhakarSingularities(const PrabhakarArguments& x);

  long double alpha, beta, gamma;
  Point log_z;
  bool integer_alpha;
  bool integer_power;                       // alpha gamma - beta is an integer >= 0
  std::vector<Point> log_roots{}, roots{};  // s* on the sheet |arg s*| <= pi

  // The exponent alpha gamma - beta of the factor s^(alpha gamma - beta) of F.
  [[nodiscard]] BigReal power_of(const PrabhakarArguments& x) const;

  // Whether 0 is no singularity.
  [[nodiscard]] bool has_no_cut() const { return integer_alpha && integer_power; }
  // Whether the term of F in s^power, power an integer, is subtracted: it contributes nothing, and F is close
  // to it on the contour if all s* are far in the left half-plane.
  [[nodiscard]] bool subtracts_leading_term() const;
  // Logarithm of an upper bound of |F|, or of the remainder if subtracts_leading_term(), on a disc.
  [[nodiscard]] long double log_majorant(const EnclosingContour::Disc& disc) const;
};

}  // namespace fde::reference
