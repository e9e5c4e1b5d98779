#pragma once

#include <vector>

#include "stability/stability_region.hpp"

namespace fde {

// A place of the boundary of a region of stability in the upper half plane: at z a mode stands at
// exp(i theta) or, for its conjugate, at exp(-i theta).
struct BoundaryPoint {
  double theta;
  ComplexValue z;
};

// What divides the stable z of a scheme from the unstable ones, at one order: of the curves on which a mode
// stands on the unit circle those parts where stability changes, each piece to be joined as it stands. Points
// are this many on a whole curve, denser at both of its ends. Throws as growing_modes does.
std::vector<std::vector<BoundaryPoint>> region_boundary(const Scheme& scheme, double order, int points);

}  // namespace fde
