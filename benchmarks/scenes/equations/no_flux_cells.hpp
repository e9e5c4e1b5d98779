#pragma once

#include "fdebench/benchmarks/scenes/equations/field_outputs.hpp"

namespace fde {

// Cells of a line or a square with a no-flux border: n an axis of the unit interval, with midpoints x_i = (i
// - 1/2) / n. `differences` is coupling n^2 times the sum over the neighbours of (u_neighbour - u_cell). The
// differences sum to 0; in a square, those of a field that does not vary with y equal those of a line.
class NoFluxCells {
 public:
  NoFluxCells(FieldShape shape, double coupling);

  [[nodiscard]] const FieldShape& shape() const { return shape_; }
  // The midpoints of the cells of an axis.
  [[nodiscard]] Vec midpoints() const;
  // The differences of a field, and the matrix of this linear map.
  void differences(In u, Out f) const;
  [[nodiscard]] SparseMatrix matrix() const;

 private:
  FieldShape shape_;
  double coupling_;  // coupling times n^2
};

}  // namespace fde
