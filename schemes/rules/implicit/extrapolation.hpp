// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Extrapolates a path by the polynomial through its n newest points,
//   y(t) = sum_i y_i prod_(j != i) (t - t_j) / (t_i - t_j).
// Where t and the points have equal distances, the weight of the k-th newest is (-1)^(k-1) n! / (k! (n-k)!).
// More points extrapolate longer steps; fewer amplify rounding errors less, 15 times in root mean square with
// five. choose_count() selects n, at most seven.
class Extrapolation {
 public:
  explicit Extrapolation(Eigen::Index size)
      : values_(Eigen::Matrix<double, Eigen::Dynamic, max_points>::Zero(size, max_points)) {}

  // Appends a point; the oldest of seven is dropped.
  void push(double t, In y);
  [[nodiscard]] bool empty() const { return point_count_ == 0; }

  // Sets value to the polynomial at t. Precondition: not empty().
  void at(double t, Out value) const;

  // Selects the number of points for which max_i scale_i |y_i(t) - value_i| is smallest. Precondition: not
  // empty().
  void choose_count(double t, In value, In scale);

  void state(Archive& archive);

 private:
  static constexpr int max_points = 7;
  using Weights = std::array<double, max_points>;  // of the points, the newest first

  [[nodiscard]] int column(int age) const {
    return newest_ >= age ? newest_ - age : newest_ - age + max_points;
  }
  [[nodiscard]] double time(int age) const { return times_[static_cast<std::size_t>(column(age))]; }
  // Whether t continues the equal distances of the newest points, up to the rounding of times.
  [[nodiscard]] bool continues_equal_distances(double t) const;
  [[nodiscard]] Weights weights(double t, int count) const;

  std::array<double, max_points> times_{};
  Eigen::Matrix<double, Eigen::Dynamic, max_points> values_;  // a column a point; the newest is newest_
  int newest_ = 0, point_count_ = 0;
  int equal_count_ = 0;   // number of the newest points that have equal distances
  int chosen_count_ = 5;  // of choose_count()
};

}  // namespace fde
