// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// P_0(x) ... P_(count-1)(x), one row a point.
Matrix legendre_polynomials(const Vec& points, Eigen::Index count);

// The collocation rule of all panels: Radau points, and functions on a panel as values at these points or as
// coefficients of Legendre polynomials. Points on a panel are in (-1, 1], the last is its end. The matrices
// act on one column a function.
//
// The end is a collocation point, so the value that a panel passes on satisfies the equations. This damps
// modes that decay within the panel. With Gauss points, all inside, the value would be that of the
// extrapolated polynomial, whose error is larger than inside, and for orders above 1 grows from panel to
// panel. Algebraic rows hold at the end too, so the next panel begins without a defect that multipliers would
// correct.
struct PanelRule {
  explicit PanelRule(Eigen::Index count);

  [[nodiscard]] Eigen::Index size() const { return points.size(); }

  Vec points;              // increasing
  Matrix to_coefficients;  // from values; exact for polynomials of degree size() - 1
  Vec at_start;            // weights of the values in the polynomial's value at -1
  // Values at the points of each half from values at the points of a block.
  Matrix to_older_half, to_newer_half;
  // Coefficients of the least-squares fit on a block: the sum of the contributions of its halves.
  Matrix from_older, from_newer;
};

// The rule with this number of points, computed once. Thread-safe; the reference is valid until the program
// ends.
const PanelRule& panel_rule(Eigen::Index points);

}  // namespace fde
