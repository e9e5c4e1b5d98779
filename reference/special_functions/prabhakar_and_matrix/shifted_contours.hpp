// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <complex>

#include "fdebench/reference/special_functions/laplace/free_strip.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/contour_kernels.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/quick_contours.hpp"

// The contours of the quick evaluations for singularities of any kind (SingularityFreeStrip), computed once.
namespace fde::reference {

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
