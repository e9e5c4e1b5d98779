#include "implicit/extrapolation.hpp"

#include <algorithm>

namespace fde {

void Extrapolation::push(double t, In y) {
  newest_ = (newest_ + 1) % points_.size();
  known_ = std::min(known_ + 1, points_.size());
  points_[newest_].t = t;
  points_[newest_].y = y;
}

void Extrapolation::at(double t, Out value) const {
  if (known_ == 0) return;
  const auto point = [&](std::size_t age) -> const Point& {
    return points_[(newest_ + points_.size() - age) % points_.size()];
  };
  value.setZero();
  for (std::size_t i = 0; i < known_; ++i) {
    double weight = 1.0;
    for (std::size_t j = 0; j < known_; ++j) {
      if (j != i) weight *= (t - point(j).t) / (point(i).t - point(j).t);
    }
    value += weight * point(i).y;
  }
}

}  // namespace fde
