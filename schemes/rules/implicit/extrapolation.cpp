// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/extrapolation.hpp"

#include <algorithm>

#include "fdebench/schemes/problem/componentwise.hpp"

namespace fde {

void Extrapolation::push(double t, In y) {
  if (point_count_ > 0) newest_ = (newest_ + 1) % max_points;
  point_count_ = std::min(point_count_ + 1, max_points);
  times_[static_cast<std::size_t>(newest_)] = t;
  values_.col(newest_) = y;
}

// The known points are in the first columns, not ordered by time.
void Extrapolation::at(double t, Out value) const {
  std::array<double, max_points> weights{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(point_count_); ++i) {
    double above = 1.0, below = 1.0;
    for (std::size_t j = 0; j < static_cast<std::size_t>(point_count_); ++j) {
      if (j == i) continue;
      above *= t - times_[j];
      below *= times_[i] - times_[j];
    }
    weights[i] = above / below;
  }
  for_each_component(value.size(), [&](Eigen::Index component) {
    double sum = 0.0;
    for (int i = 0; i < point_count_; ++i)
      sum += weights[static_cast<std::size_t>(i)] * values_(component, i);
    value[component] = sum;
  });
}

void Extrapolation::state(Archive& archive) {
  archive.count(point_count_, 0, max_points);
  archive.count(newest_, 0, max_points - 1);
  archive(times_);
  archive.values(values_.data(), point_count_ * values_.rows());
}

}  // namespace fde
