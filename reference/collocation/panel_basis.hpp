#pragma once

#include "problem/problem.hpp"
#include "quadrature/gauss.hpp"

namespace fde {

// Where a panel has its nodes. Gauss-Radau points have the end among them, and what algebraic rows say there
// holds for the start of the next panel: an error of the last panel is forgotten. With Gauss-Legendre points
// it would come back with the other sign, for ever.
enum class PanelPoints { legendre, radau };

// Polynomials through these points: all that is the same on every panel, for the panel [0, 1].
struct PanelBasis {
  PanelBasis(int count, PanelPoints kind);

  GaussRule gauss;
  Vec nodes, weights;              // the same in double
  Vec targets;                     // nodes and 1: where a panel evaluates the solution
  Vec dense_nodes, dense_weights;  // 0 and targets with barycentric weights: where a panel keeps the solution
  Matrix at_targets;               // values at the targets from those at the nodes
  Matrix left_half, right_half;    // values at the nodes of a half of the panel from those at its own nodes
  Matrix legendre;                 // coefficients of Legendre polynomials from values at the nodes

  [[nodiscard]] Eigen::Index points() const { return nodes.size(); }

  // (i, j): 1/Gamma(order) int_0^x (x-s)^(order-1) l_j(s) ds at x = targets[i], l_j the Lagrange polynomials.
  [[nodiscard]] Matrix integral(double order) const;

  // The polynomial with a row of values at each of dense_nodes.
  [[nodiscard]] Vec interpolate(const Matrix& values, double x) const;
};

}  // namespace fde
