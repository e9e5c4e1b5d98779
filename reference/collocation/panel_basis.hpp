#pragma once

#include "problem/problem.hpp"
#include "quadrature/gauss.hpp"

namespace fde {

// Polynomials through Gauss-Legendre points: all that is the same on every panel, for the panel [0, 1].
struct PanelBasis {
  explicit PanelBasis(int points);

  GaussRule gauss;
  Vec nodes, weights;              // the same in double
  Vec targets;                     // nodes, 1: where a panel evaluates the solution
  Vec dense_nodes, dense_weights;  // 0, nodes, 1 with barycentric weights: where a panel keeps the solution
  Matrix left_half, right_half;    // values at the nodes of a half of the panel from those at its own nodes
  Matrix legendre;                 // coefficients of Legendre polynomials from values at the nodes

  [[nodiscard]] Eigen::Index points() const { return nodes.size(); }

  // (i, j): 1/Gamma(order) int_0^x (x-s)^(order-1) l_j(s) ds at x = targets[i], l_j the Lagrange polynomials.
  [[nodiscard]] Matrix integral(double order) const;

  // The polynomial with a row of values at each of dense_nodes.
  [[nodiscard]] Vec interpolate(const Matrix& values, double x) const;
};

}  // namespace fde
