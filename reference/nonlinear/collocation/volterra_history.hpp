// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/nonlinear/collocation/panel_basis.hpp"

namespace fde::reference {

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

  // Taylor part + 1/Gamma(gamma_i) int_0^from (t-s)^(gamma_i-1) f_i(s) ds at the targets t of the panel
  // [from, to]; for algebraic rows the value at `from`. One row per target, one column per component.
  // Precondition: the panels in `panels` cover [0, from].
  [[nodiscard]] Matrix at_targets(const std::vector<Panel>& panels, double from, double to) const;

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
};

}  // namespace fde::reference
