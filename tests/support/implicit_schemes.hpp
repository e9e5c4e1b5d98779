// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "support/testing.hpp"

namespace fde::bench {

// The schemes that support algebraic rows. They solve an equation in each step.
inline std::vector<const Scheme*> implicit_schemes() {
  auto some = row_schemes();
  std::erase_if(some, [](const Scheme* scheme) { return !scheme->capabilities.algebraic_rows; });
  return some;
}

// A uniform grid and, if the scheme supports it, a graded one.
inline std::vector<Grid> grids_of(const Scheme& scheme, double end, int steps) {
  std::vector<Grid> grids{{end, steps}};
  if (!scheme.capabilities.uniform_grid) grids.push_back({end, steps, 2.0});
  return grids;
}

}  // namespace fde::bench
