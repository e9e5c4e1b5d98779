#pragma once

#include "scenes/equations/linear_field.hpp"
#include "scenes/equations/sine_modes.hpp"

namespace fde {

// u_t^g = kappa (u_xx, or u_xx + u_yy) at points inside (0, 1), or inside the unit square where component i +
// n j is at (x_i, x_j), with second differences in place of derivatives and u = 0 at the border. At t = 0 u
// is the start, of a square start(x) start(y), and without velocity. In time the solution is known: each mode
// is E_g(-rate t^g) of what it was.
class SineField final : public LinearField {
 public:
  SineField(SinePoints points, SineStart start, int dimensions, double order, double diffusivity);

  [[nodiscard]] FieldShape shape() const override { return shape_; }
  [[nodiscard]] const Vec& start() const override { return start_.values; }
  [[nodiscard]] SparseMatrix matrix() const override;
  void apply(In u, Out f) const override;
  // With the maximum where points times modes are at most 8 million.
  [[nodiscard]] Outputs outputs() const override;
  [[nodiscard]] bool known() const override { return true; }
  [[nodiscard]] ReferenceValue at(double t) const override;

 private:
  class Sum;
  [[nodiscard]] double coupling() const;
  // The largest |u| of all points, for amplitudes of the modes: modes x 1, or x modes in a square.
  [[nodiscard]] double largest(const Matrix& amplitudes) const;

  SinePoints points_;
  SineStart start_;
  FieldShape shape_;
  double order_, diffusivity_;
  Matrix sines_;        // of each mode at the points of an axis that are shown, a column a mode
  Matrix all_sines_{};  // at all of its points; empty where there is no maximum
};

}  // namespace fde
