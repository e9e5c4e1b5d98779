// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

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

// A solved panel: f and y are polynomials in time, one row per point, one column per component.
struct Panel {
  double from, to;
  Matrix rhs;      // f at the nodes
  Matrix values;   // y at the start, at the nodes and at the end
  Vec size;        // of y and of its terms: the rounding errors of y are relative to this
  Vec negligible;  // of f: coefficients up to which it is resolved

  [[nodiscard]] double length() const { return to - from; }
};

// The history term on a panel, for the Volterra form of the problem.
class HistoryTerm {
 public:
  HistoryTerm(const Problem& problem, const PanelBasis& basis);

  // Taylor part + jumps + 1/Gamma(gamma_i) int_0^from (t-s)^(gamma_i-1) f_i(s) ds at the targets t of the
  // panel [from, to]; for algebraic rows the value at `from`. One row per target, one column per component.
  // Precondition: the panels in `panels` cover [0, from].
  [[nodiscard]] Matrix at_targets(const std::vector<Panel>& panels, double from, double to) const;

  // y jumps at the end of the last panel.
  void add_jump(In jump) { jumps_ += jump; }

 private:
  // Components of the same order share the evaluation of their kernel.
  struct Kernel {
    double order;
    std::vector<Eigen::Index> components;
  };

  void add_panel(const Panel& source, const Vec& gap, Matrix& integral) const;
  void add_piece(const Matrix& rhs, double length, const Vec& gap, Eigen::Ref<Matrix> integral) const;

  const Problem& problem_;
  const PanelBasis& basis_;
  std::vector<Kernel> kernels_;
  Vec jumps_;  // the sum so far
};

}  // namespace fde::reference
