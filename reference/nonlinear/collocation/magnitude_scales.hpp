// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// The coefficients of f are resolved to so many rounding errors of its forcing.
inline constexpr double roundings_of_forcing = 16.0;

// Sizes to which rounding errors and tolerances are relative: the largest so far, one number per component.
struct MagnitudeScales {
  Vec values;   // of y_i
  Vec rhs;      // of the terms of f_i
  Vec forcing;  // of f_i at the initial values, over all times: 1 - cos t is mostly rounding near 0
  Vec noise;    // rounding errors of terms of f_i that cancel for every y, which no size shows

  [[nodiscard]] double largest() const { return values.cwiseMax(rhs).maxCoeff(); }
};

// For a problem with algebraic rows, sets the sizes of f and of the unknowns of these rows to 0: both may be
// unbounded at the start and are then no measure for later panels.
MagnitudeScales without_unbounded_scales(MagnitudeScales sizes, const Problem& problem);

MagnitudeScales sizes_at_start(const Problem& problem);

// The sizes including y and f at the nodes of a panel, one row per node, with df/dy there.
MagnitudeScales updated_scales(const MagnitudeScales& before, const Matrix& y, const Matrix& rhs,
                               const std::vector<Matrix>& jacobians);

}  // namespace fde::reference
