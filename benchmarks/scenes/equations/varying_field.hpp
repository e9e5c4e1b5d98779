#pragma once

#include <mutex>

#include "scenes/equations/linear_field.hpp"
#include "scenes/equations/medium.hpp"

namespace fde {

// D^g u = kappa div(a(x) grad u) at points inside (0, 1), or inside the unit square, with conservative second
// differences,
//   kappa ((u_(i+1) - u_i) a_(i+1/2) - (u_i - u_(i-1)) a_(i-1/2)) / dx^2,
// in y with a_i, and u = 0 at the border. In y sines are eigenvectors; what is left of each is tridiagonal in
// x, and its eigenvectors are computed when a solution is first asked for.
class VaryingField final : public LinearField {
 public:
  VaryingField(SinePoints points, SineStart start, int dimensions, double order, double diffusivity,
               const Medium& medium);

  [[nodiscard]] FieldShape shape() const override { return shape_; }
  [[nodiscard]] const Vec& start() const override { return start_.values; }
  [[nodiscard]] SparseMatrix matrix() const override;
  void apply(In u, Out f) const override;
  [[nodiscard]] Outputs outputs() const override;
  // Where eigenvectors take seconds at most: 500 points of a line, 350 x 350 from three modes, 100 x 100 from
  // a step.
  [[nodiscard]] bool known() const override;
  [[nodiscard]] ReferenceValue at(double t) const override;

 private:
  // The eigenvectors v_k of a tridiagonal matrix T, a column each, T v_k = -rate_k v_k + r_k, and what they
  // say of the start: sum_k amplitude_k v_k, but for what is missing. Of a sine in y, or 0 on a line.
  struct Modes {
    int of_y;
    double amplitude_of_y;
    Vec rates, amplitudes, residuals;  // residuals: |r_k|_2
    Matrix vectors;
    double missing;  // its norm
  };
  [[nodiscard]] Modes modes_of(int of_y) const;
  [[nodiscard]] const std::vector<Modes>& modes() const;

  SinePoints points_;
  SineStart start_;
  FieldShape shape_;
  double order_;
  Vec across_;  // kappa a / dx^2 between neighbours in x, n + 1
  Vec along_;   // between those in y, n; empty on a line
  Vec middle_;  // what A multiplies u_i by, n
  mutable std::once_flag decomposed_{};
  mutable std::vector<Modes> modes_{};
};

}  // namespace fde
