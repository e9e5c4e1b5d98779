// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
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

// The symmetric matrix that couples each point with its neighbours: point i of a line with i - 1 by
// x_coupling[i], and with point i of the next line by y_coupling[i]; diagonal(k) is entry (k, k).
SparseMatrix five_point_matrix(const FieldShape& shape, const Vec& x_coupling, const Vec& y_coupling,
                               const std::function<double(Eigen::Index place)>& diagonal);

// D^order u = A u at the points of a field, with A symmetric and sparse. u(0) is a product of functions of
// one axis each, and u'(0) = 0.
class LinearField {
 public:
  LinearField() = default;
  LinearField(const LinearField&) = delete;
  LinearField& operator=(const LinearField&) = delete;
  virtual ~LinearField() = default;

  [[nodiscard]] virtual FieldShape shape() const = 0;
  [[nodiscard]] virtual const Vec& initial_values_on_axis() const = 0;  // u(0) along an axis
  // A as a matrix, and f = A u.
  [[nodiscard]] virtual SparseMatrix matrix() const = 0;
  virtual void apply(In u, Out f) const = 0;
  [[nodiscard]] virtual Outputs outputs() const = 0;
  // Whether an exact solution in time is available; exact_columns_at(t) gives its columns and must be
  // thread-safe.
  [[nodiscard]] virtual bool has_exact_solution() const = 0;
  [[nodiscard]] virtual reference::ReferenceValue exact_columns_at(double t) const = 0;
};

// The components of a field of this order with u(0) = start(x), or start(x) start(y) in a square.
std::vector<Component> field_components(const FieldShape& shape, const Vec& start, double order);

// The scene of a field: problem, columns, smoothness and, if known, the reference.
Scene scene_of_field(const std::shared_ptr<const LinearField>& field, double order);

}  // namespace fde::bench
