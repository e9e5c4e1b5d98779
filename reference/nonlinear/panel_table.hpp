#pragma once

#include <vector>

#include "reference.hpp"

namespace fde {

// A panel of a solution: y is the polynomial through its values at 0, at Gauss points and at 1 of the panel.
struct ReferencePanel {
  double from, to;
  Matrix values;  // a row a point, a column a component
  Vec bound;      // of the error on the panel
};

// A solution from 0 to the end of the last panel: all that a reference is evaluated from, to be kept.
struct PanelTable {
  std::vector<ReferencePanel> panels;
};

// At t = 0 its bound is that of the start. Throws std::invalid_argument from Reference::at for a time outside
// the panels. There is a panel at least.
Reference panel_reference(PanelTable table, Vec bound_of_start);

}  // namespace fde
