// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Extrapolates a path by the polynomial through its last points, at most five:
//   y(t) = sum_i y_i prod_(j != i) (t - t_j) / (t_i - t_j).
class Extrapolation {
 public:
  explicit Extrapolation(Eigen::Index size) : values_(size, max_points) {}

  // Appends a point; the oldest of five is dropped.
  void push(double t, In y);
  [[nodiscard]] bool empty() const { return point_count_ == 0; }

  // Sets value to the polynomial at t. Precondition: not empty().
  void at(double t, Out value) const;

  void state(Archive& archive);

 private:
  static constexpr int max_points = 5;

  std::array<double, max_points> times_{};
  Eigen::Matrix<double, Eigen::Dynamic, max_points> values_;  // a column a point; the newest is newest_
  int newest_ = 0, point_count_ = 0;
};

}  // namespace fde
