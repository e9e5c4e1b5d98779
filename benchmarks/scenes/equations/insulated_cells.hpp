#pragma once

#include "scenes/equations/field_outputs.hpp"

namespace fde {

// Cells of a line or a square whose border nothing crosses: n an axis of the unit interval, their middles at
// x_i = (i - 1/2) / n. The differences are coupling n^2 times the sum over a cell's neighbours of u there
// less u here; they sum to 0, and are those of a line where a field in a square does not vary with y.
class InsulatedCells {
 public:
  InsulatedCells(FieldShape shape, double coupling);

  [[nodiscard]] const FieldShape& shape() const { return shape_; }
  // The middles of the cells of an axis.
  [[nodiscard]] Vec middles() const;
  // The differences of a field, and as a matrix.
  void differences(In u, Out f) const;
  [[nodiscard]] SparseMatrix matrix() const;

 private:
  FieldShape shape_;
  double coupling_;  // times n^2
};

}  // namespace fde
