#pragma once

#include <vector>

#include "scenes/scene.hpp"

namespace fde {

// Points of a line, or of a square where component i + points j is at (x_i, x_j), i and j counted from 0.
struct FieldShape {
  int points;  // of an axis
  int dimensions;

  [[nodiscard]] Eigen::Index size() const;
};

// Whether a field has columns for all of its points: a line of at most 2000.
bool all_shown(const FieldShape& shape);

// The points of an axis that are shown, counted from 1: all, nine of a longer line, three of each side.
std::vector<int> shown_points(const FieldShape& shape);

// The columns of a field: u at the points that are shown, u{i} or u{i}_{j}. Where these are not all, l2, the
// root of sum u^2 / intervals^dimensions, 1 / intervals the distance of points; and max, the largest |u| of
// all points, where that is asked for.
Outputs field_outputs(const FieldShape& shape, double intervals, bool with_maximum);

}  // namespace fde
