#pragma once

#include <array>

#include "problem/vectors.hpp"

namespace fde {

// A path continued from its last points, by the polynomial through as many of them as there are, up to three:
// y(t) = sum_i y_i prod_(j != i) (t - t_j) / (t_i - t_j).
class Extrapolation {
 public:
  void push(double t, In y);

  // value becomes that at t; it is left as it is where no point is known.
  void at(double t, Out value) const;

 private:
  struct Point {
    double t = 0.0;
    Vec y;
  };
  std::array<Point, 3> points_;  // the newest is points_[newest_]
  std::size_t newest_ = 0, known_ = 0;
};

}  // namespace fde
