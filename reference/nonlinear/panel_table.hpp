// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/reference.hpp"

namespace fde::reference {

// A panel of a solution: y is the polynomial through its values at the start of the panel, at the
// Gauss-Legendre points and at the end.
struct ReferencePanel {
  double from, to;
  Matrix values;  // one row per point, one column per component
  Vec bound;      // of the error on the panel
};

// A solution from 0 to the end of the last panel, in a form that can be stored.
struct PanelTable {
  std::vector<ReferencePanel> panels;
};

// The Reference of a table; at t = 0 its bound is initial_bound. Reference::at throws std::invalid_argument
// for a time outside the panels. Precondition: at least one panel, all with the same number of points.
Reference reference_from_panels(PanelTable table, Vec initial_bound);

}  // namespace fde::reference
