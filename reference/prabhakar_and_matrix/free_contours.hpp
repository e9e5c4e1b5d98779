#pragma once

#include <array>
#include <complex>

#include "laplace/free_strip.hpp"
#include "mittag_leffler/contour_kernels.hpp"
#include "mittag_leffler/quick_residues.hpp"

// The contours of the quick evaluations for singularities of any kind, made once.
namespace fde {

struct FreeContour {
  explicit FreeContour(const ShiftedShape& of);

  ShiftedShape shape;
  FreeStrip strip;
  ContourNodes nodes;
};

// Of what a contour neglects, against the largest that the value may be: no more will do.
inline constexpr double most_log_neglected = -33.0;

// In the order in which they are worth a try.
const std::array<FreeContour, 8>& free_contours();

// The singularities s*^alpha = z as FreeStrip has them.
struct FreeRoots {
  FreeRoots(double alpha, const std::complex<double>& log_z, int first_sheet);

  double log_size;
  Poles<double> poles;
  EachSheet<std::complex<double>> roots;

  // The largest Re s* on the principal sheet, at least 0: the function does not grow faster than e to that.
  [[nodiscard]] double growth() const;
  [[nodiscard]] FreeStrip::Factor factor(double strength) const {
    return {log_size, poles.nearest_sheet, {roots.data(), roots.size()}, strength};
  }
};

}  // namespace fde
