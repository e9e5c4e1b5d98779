#pragma once

#include <array>
#include <span>

#include "laplace/contour_bound.hpp"
#include "mittag_leffler/contour_kernels.hpp"

// The contours of the quick evaluation, made once.
namespace fde {

// A contour with what its bound and its kernels want to know.
struct QuickContour {
  explicit QuickContour(const ContourShape& of);

  ContourShape shape;
  ContourBound bound;
  DoubleDouble half_log_mu;
  ContourNodes nodes;
};

// Two contours with nodes half a step apart, and the exponents of F = s^exponent / (s^alpha - z) that they
// are meant for: how F behaves for small s, and for large s.
struct QuickContours {
  double least_exponent, most_exponent;
  std::array<QuickContour, 2> twins;

  [[nodiscard]] bool fit(double least, double most) const {
    return least >= least_exponent && most <= most_exponent;
  }
  // The twin whose nodes stay farther away from the poles; roots as in ContourBound.
  [[nodiscard]] const QuickContour& farther_from(std::span<const std::complex<double>> roots) const;
};

// In the order in which they are worth a try.
const std::array<QuickContours, 6>& quick_contours();

}  // namespace fde
