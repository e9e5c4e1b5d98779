// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "fdebench/schemes/diagnostics/stability_region.hpp"

namespace fde {

// The root that is closest to z: it continues the boundary curve through z. Precondition: roots is not empty.
inline ComplexValue nearest_root(const std::vector<ComplexValue>& roots, ComplexValue z) {
  return std::ranges::min(roots, {}, [&](ComplexValue root) { return std::abs(root - z); });
}

// A vector of length part * |z|, normal to the boundary curve at its point z of the angle theta.
inline ComplexValue boundary_normal(const Scheme& scheme, double order, double theta, ComplexValue z,
                                    double part) {
  const ComplexValue along = nearest_root(root_locus(scheme, order, 0.999 * theta), z) - z;
  return ComplexValue(0.0, part * std::abs(z)) * along / std::abs(along);
}

}  // namespace fde
