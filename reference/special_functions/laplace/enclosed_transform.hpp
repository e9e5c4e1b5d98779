// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/laplace/enclosing_contour.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"

namespace fde::reference {

// Laplace transforms that invert() inverts at time 1 on enclosing contours (separate_contours()).
struct EnclosedTransform {
  using Sums = std::vector<BoundedSum<BigReal>>;
  // An evaluation at one precision.
  struct Evaluation {
    // Adds weight F(s) of each transform to its sum; the vector of sums is empty before the first node.
    std::function<void(const EnclosingContour::Node&, Sums&)> add;
    // The inverse transforms from the sums, where these are sums of other transforms.
    std::function<Sums(const Sums&)> finish = [](const Sums& sums) { return sums; };
  };

  std::vector<EnclosingContour::Point> singularities;
  EnclosingContour::Hints hints{};
  bool real = false;  // F(conj s) = conj F(s), conjugate singularities: the upper half suffices
  // Reads the data of the problem at the current precision.
  std::function<Evaluation()> prepare{};
  // Working digits beyond those of the contour that cancellation takes.
  std::function<int(const EnclosingContour&)> lost_digits = [](const EnclosingContour&) { return 0; };
  // One per transform, or a single one for all.
  std::vector<EnclosingContour::Majorant> majorants{};
  // A value this many digits smaller than its summands counts as zero.
  int zero_digits = 40;
};

// For F ~ s^-beta at large s: on the real axis e^s s^-beta is smallest at s = beta, and far left of it the
// terms would exceed their sum by far. Keeps the contours right of it if beta is large.
void keep_right_of_saddle_point(EnclosedTransform& transform, long double beta);

// One value per transform. Raises the working digits until every bound is at most 10^-wanted_digits of its
// value: discretisation errors by EnclosingContour::log_bound, rounding errors by BoundedSum. A value that
// counts as zero has that accuracy relative to its summands, as in increase_digits(). Throws
// std::runtime_error where a contour takes too many nodes or a singularity is too far up, e^s overflows, or 4
// wanted_digits + 1000 working digits do not suffice.
std::vector<Bounded<BigReal>> invert(const EnclosedTransform& transform, int wanted_digits);

}  // namespace fde::reference
