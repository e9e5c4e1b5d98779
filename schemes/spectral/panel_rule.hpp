#pragma once

#include "problem/vectors.hpp"

namespace fde {

// P_0(x) ... P_(count-1)(x), one row a point.
Matrix legendre_polynomials(const Vec& points, Eigen::Index count);

// What all panels share: the points of collocation, which are Radau's, and functions on a panel as their
// values there or as coefficients of Legendre polynomials. Places on a panel are in (-1, 1], the last is its
// end. One column a function throughout.
//
// With the end among them a panel hands on what its equations have there. Where f makes a mode decay within
// the panel that damps it; Gauss's points, all inside, would hand on what the polynomial is at the end, which
// is off by more than it is inside, for orders above 1 by more from panel to panel. And algebraic rows hold
// there: the next panel begins without a defect for multipliers to answer.
struct PanelRule {
  explicit PanelRule(Eigen::Index points);

  [[nodiscard]] Eigen::Index size() const { return places.size(); }

  Vec places;                     // increasing
  Matrix to_coefficients;         // from values; exact for polynomials of degree size() - 1
  Vec at_start, at_end;           // weights of the values in the polynomial's value at -1 and at 1
  Matrix older_half, newer_half;  // values at the places of each half from values at the places of a block
  Matrix from_older,
      from_newer;  // coefficients of a block, as best fits, from those of its halves: their sum
};

// The rule of so many points, made once. Safe from any thread; it lasts until the program ends.
const PanelRule& panel_rule(Eigen::Index points);

}  // namespace fde
