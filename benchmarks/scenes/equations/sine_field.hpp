// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/scenes/equations/linear_field.hpp"
#include "fdebench/benchmarks/scenes/equations/sine_modes.hpp"

namespace fde::bench {

// D^g u = kappa (u_xx, or u_xx + u_yy) at points inside (0, 1), or inside the unit square where component i +
// n j is at (x_i, x_j), with second differences in place of derivatives and u = 0 at the border. u(0) is
// start(x), or start(x) start(y) in a square, and u'(0) = 0. The solution in time is exact: each mode is its
// initial amplitude times E_g(-rate t^g).
class SineField final : public LinearField {
 public:
  SineField(SineGrid points, InitialField initial_values_on_axis, int dimensions, double order,
            double diffusivity);

  [[nodiscard]] FieldShape shape() const override { return shape_; }
  [[nodiscard]] const Vec& initial_values_on_axis() const override { return start_.values; }
  [[nodiscard]] SparseMatrix matrix() const override;
  void apply(In u, Out f) const override;
  // The column max is included if points times modes are at most 8 million.
  [[nodiscard]] Outputs outputs() const override;
  [[nodiscard]] bool has_exact_solution() const override { return true; }
  [[nodiscard]] reference::ReferenceValue exact_columns_at(double t) const override;

 private:
  class Sum;
  [[nodiscard]] double coupling() const;
  // apply() for `count` points from `first` on, within a line.
  void apply_to_part_of_line(In u, Out f, Eigen::Index first, Eigen::Index count) const;
  // The largest |u| of all points, for the amplitudes of the modes: modes x 1, or modes x modes in a square.
  [[nodiscard]] double largest(const Matrix& amplitudes) const;

  SineGrid points_;
  InitialField start_;
  FieldShape shape_;
  double order_, diffusivity_;
  Matrix sines_;        // of each mode at the points of an axis that are columns, one column a mode
  Matrix all_sines_{};  // at all points of an axis; empty without the column max
};

}  // namespace fde::bench
