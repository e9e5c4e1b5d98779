#pragma once

#include <vector>

#include "collocation/panel_basis.hpp"

namespace fde {

// A solved panel: f and y there are polynomials in time, a column a component.
struct Panel {
  double from, to;
  Matrix rhs;     // f at the nodes
  Matrix values;  // y at the start, at the nodes and at the end
  Vec size;       // of y and of the terms that it is made of: its rounding errors are relative to that

  [[nodiscard]] double length() const { return to - from; }
};

// What the past contributes to a panel of the Volterra form of the problem.
class VolterraHistory {
 public:
  VolterraHistory(const Problem& problem, const PanelBasis& basis);

  // Taylor part + 1/Gamma(gamma_i) int_0^from (t-s)^(gamma_i-1) f_i(s) ds at the targets t of the panel
  // [from, to], where the past panels end; of algebraic rows the value at `from`. A row a target, a column a
  // component.
  [[nodiscard]] Matrix at_targets(const std::vector<Panel>& past, double from, double to) const;

 private:
  // Components of one order share the evaluation of their kernel.
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

}  // namespace fde
