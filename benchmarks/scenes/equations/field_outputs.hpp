// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// Points of a line, or of a square, where component i + points j is at (x_i, x_j), i and j counted from 0.
struct FieldShape {
  int points;  // of an axis
  int dimensions;

  [[nodiscard]] Eigen::Index size() const;
};

// Whether all points of a field are columns: a line of at most 2000 points.
bool outputs_all_points(const FieldShape& shape);

// The points of an axis that are columns, counted from 1: all, nine of a longer line, or three of each side
// of a square.
std::vector<int> output_points(const FieldShape& shape);

// The columns of a field: u at output_points(), named u{i} or u{i}_{j}. If these are not all points, also l2
// = sqrt(sum u^2 / intervals^dimensions), where 1 / intervals is the distance of points; and, with
// with_maximum, max, the largest |u| of all points.
Outputs field_outputs(const FieldShape& shape, double intervals, bool with_maximum);

}  // namespace fde::bench
