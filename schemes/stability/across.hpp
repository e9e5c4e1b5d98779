#pragma once

#include <algorithm>

#include "stability/stability_region.hpp"

namespace fde {

// The root of the boundary that continues z.
inline ComplexValue nearest(const std::vector<ComplexValue>& roots, ComplexValue z) {
  return std::ranges::min(roots, {}, [&](ComplexValue root) { return std::abs(root - z); });
}

// A step across the boundary at z, its value at this theta, of this part of |z|.
inline ComplexValue across(const Scheme& scheme, double order, double theta, ComplexValue z, double part) {
  const ComplexValue along = nearest(boundary(scheme, order, 0.999 * theta), z) - z;
  return ComplexValue(0.0, part * std::abs(z)) * along / std::abs(along);
}

}  // namespace fde
