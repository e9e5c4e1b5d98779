#pragma once

#include "prabhakar_and_matrix/prabhakar_transform.hpp"

namespace fde {

// Where the singularities of Prabhakar's transform are, which form of it to take, and how large it is: what
// needs no more than long double. z may be beyond its exponents.
struct PrabhakarShape {
  using Point = EnclosingContour::Point;

  // At a precision of 120 digits: sums of the arguments are whole if they are to 100.
  explicit PrabhakarShape(const PrabhakarArguments& x);

  long double alpha, beta, gamma;
  Point log_z;
  bool whole_alpha;
  bool whole_power;                         // alpha gamma - beta is whole and not negative
  std::vector<Point> log_roots{}, roots{};  // s*, on the sheet

  // alpha gamma - beta, of s beside (s^alpha - z)^-gamma.
  [[nodiscard]] BigReal power_of(const PrabhakarArguments& x) const;

  // 0 is no singularity.
  [[nodiscard]] bool cut_free() const { return whole_alpha && whole_power; }
  // Far from all s* a whole power leaves little of F but s^power, which has nothing to contribute.
  [[nodiscard]] bool peeled() const;
  // Logarithm of an upper bound of |F|, or of what is left of it, on a disc.
  [[nodiscard]] long double log_majorant(const EnclosingContour::Disc& disc) const;
};

}  // namespace fde
