// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

#include "fdebench/reference/special_functions/laplace/contour_bound.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/contour_kernels.hpp"

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

}  // namespace fde::reference
