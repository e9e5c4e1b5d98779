#pragma once

#include "scenes/equations/sine_modes.hpp"

namespace fde {

// u_t^g = kappa (u_xx, or u_xx + u_yy) at points inside (0, 1), or inside the unit square where component i +
// n j is at (x_i, x_j), with second differences in place of derivatives and u = 0 at the border. At t = 0 u
// is the start, of a square start(x) start(y), and without velocity. In time the solution is known: each mode
// is E_g(-rate t^g) of what it was.
class SineField {
 public:
  SineField(SinePoints points, SineStart start, int dimensions, double order, double diffusivity);

  [[nodiscard]] std::vector<Component> components() const;
  // kappa times the second differences, as a matrix and of a field.
  [[nodiscard]] SparseMatrix matrix() const;
  void differences(In u, Out f) const;
  // u at all points of a line of at most 2000; otherwise at a few, and `l2`, the root of dx^dimensions sum
  // u^2.
  [[nodiscard]] Outputs outputs() const;
  [[nodiscard]] ReferenceValue at(double t) const;

 private:
  class Sum;
  [[nodiscard]] Eigen::Index size() const;
  [[nodiscard]] double coupling() const;

  SinePoints points_;
  SineStart start_;
  int dimensions_;
  double order_, diffusivity_;
  bool with_norm_;
  std::vector<int> shown_;  // the points of an axis that are shown
  Matrix sines_;            // of each mode at these, a column a mode
};

// The problem of a field with all that is known about it.
Scene scene_of_field(const SineField& field, double order);

}  // namespace fde
