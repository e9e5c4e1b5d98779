// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/scenes/equations/field_outputs.hpp"

namespace fde::bench {

// Cells of a line or a square with a no-flux border: n an axis of the unit interval, with midpoints x_i = (i
// - 1/2) / n. In each cell the discrete Laplacian of a field u is coupling n^2 times the sum over the
// neighbours of (u_neighbour - u_cell). Its sum over all cells is 0; in a square, the Laplacian of a field
// that does not vary with y equals that on a line.
class NoFluxCells {
 public:
  NoFluxCells(FieldShape shape, double coupling);

  [[nodiscard]] const FieldShape& shape() const { return shape_; }
  // The midpoints of the cells of an axis.
  [[nodiscard]] Vec midpoints() const;
  // Sets f to the discrete Laplacian of u; and the matrix of this linear map.
  void apply_laplacian(In u, Out f) const;
  [[nodiscard]] SparseMatrix matrix() const;

 private:
  FieldShape shape_;
  double coupling_;  // coupling times n^2
};

}  // namespace fde::bench
