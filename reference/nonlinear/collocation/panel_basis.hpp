// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/nonlinear/quadrature/gauss.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// The nodes of a panel. Gauss-Radau points include the end of the panel: the algebraic rows hold at the start
// of the next one, which damps errors of the unknowns. With Gauss-Legendre points these errors would persist
// with alternating sign.
enum class PanelPoints { legendre, radau };

// Points and matrices for polynomials on the panel [0, 1], the same for every panel.
struct PanelBasis {
  PanelBasis(int count, PanelPoints kind);

  GaussRule gauss;
  Vec nodes, weights;  // the same in double
  Vec targets;         // the nodes and 1, where a panel computes the solution
  Vec dense_nodes,
      dense_weights;             // 0 and the targets, where a panel stores the solution; barycentric weights
  Matrix at_targets;             // values at the targets from those at the nodes
  Matrix left_half, right_half;  // values at the nodes of a half of the panel from those at its own nodes
  Matrix legendre;               // coefficients of Legendre polynomials from values at the nodes

  [[nodiscard]] Eigen::Index points() const { return nodes.size(); }

  // (i, j): 1/Gamma(order) int_0^x (x-s)^(order-1) l_j(s) ds at x = targets[i], l_j the Lagrange polynomials.
  [[nodiscard]] Matrix integral(double order) const;

  // The value at x of the polynomial through `values`, one row for each of dense_nodes.
  [[nodiscard]] Vec interpolate(const Matrix& values, double x) const;
};

}  // namespace fde::reference
