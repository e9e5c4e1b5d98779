// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/diagnostics/stability_region.hpp"

namespace fde {

// A point z in the upper half plane of the boundary of a stability region: for this z the symbol has a zero
// at zeta = exp(i theta) or, for the conjugate of z, at exp(-i theta).
struct BoundaryPoint {
  double theta;
  ComplexValue z;
};

// The boundary of the stability region of a scheme at one order: the parts of the root locus curve (where a
// mode is on the unit circle) across which stability changes. Each piece is a polyline in the order of its
// points; a whole curve has points + 1 points, denser at both ends. Throws as count_growing_modes does.
std::vector<std::vector<BoundaryPoint>> region_boundary(const Scheme& scheme, double order, int points);

}  // namespace fde
