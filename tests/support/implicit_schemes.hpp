#pragma once

#include <vector>

#include "support/testing.hpp"

namespace fde {

// The schemes that take algebraic rows. They solve an equation each step.
inline std::vector<const Scheme*> implicit_schemes() {
  auto some = row_schemes();
  std::erase_if(some, [](const Scheme* scheme) { return !scheme->needs.algebraic_rows; });
  return some;
}

// A uniform grid and, where the scheme takes one, a graded one.
inline std::vector<Grid> grids_of(const Scheme& scheme, double end, int steps) {
  std::vector<Grid> grids{{end, steps}};
  if (!scheme.needs.uniform_grid) grids.push_back({end, steps, 2.0});
  return grids;
}

}  // namespace fde
