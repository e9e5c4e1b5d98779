// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/laplace/enclosing_contour.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"

namespace fde::reference {

// Laplace transforms that invert() inverts at time 1 on one enclosing contour.
struct EnclosedTransform {
  // Adds weight F(s) of each transform to its sum; the vector of sums is empty before the first node.
  using NodeAccumulator =
      std::function<void(const EnclosingContour::Node&, std::vector<BoundedSum<BigReal>>&)>;

  std::vector<EnclosingContour::Point> singularities;
  EnclosingContour::Hints hints{};
  bool real = false;  // F(conj s) = conj F(s), conjugate singularities: the upper half suffices
  // Reads the data of the problem at the current precision.
  std::function<NodeAccumulator()> prepare{};
  // One per transform, or a single one for all.
  std::vector<EnclosingContour::Majorant> majorants{};
  // A value this many digits smaller than its summands counts as zero.
  int zero_digits = 40;
};

// One value per transform. Raises the working digits until every bound is at most 10^-wanted_digits of its
// value: discretisation error by EnclosingContour::log_bound, rounding error by BoundedSum. A value that
// counts as zero has that accuracy relative to its summands, as in increase_digits(). Throws
// std::runtime_error where the contour takes too many nodes, e^s overflows, or 4 wanted_digits + 1000 working
// digits do not suffice.
std::vector<Bounded<BigReal>> invert(const EnclosedTransform& transform, int wanted_digits);

}  // namespace fde::reference
