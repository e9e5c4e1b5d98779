#include "implicit/extrapolation.hpp"

#include <algorithm>

namespace fde {

void Extrapolation::push(double t, In y) {
  if (known_ > 0) newest_ = (newest_ + 1) % most;
  known_ = std::min(known_ + 1, most);
  times_[static_cast<std::size_t>(newest_)] = t;
  values_.col(newest_) = y;
}

// The points that are known are the first ones, in whatever order.
void Extrapolation::at(double t, Out value) const {
  value.setZero();
  for (int i = 0; i < known_; ++i) {
    const double own = times_[static_cast<std::size_t>(i)];
    double above = 1.0, below = 1.0;
    for (int j = 0; j < known_; ++j) {
      if (j == i) continue;
      const double other = times_[static_cast<std::size_t>(j)];
      above *= t - other;
      below *= own - other;
    }
    value += above / below * values_.col(i);
  }
}

void Extrapolation::state(Archive& archive) {
  archive.count(known_, 0, most);
  archive.count(newest_, 0, most - 1);
  archive(times_);
  archive.values(values_.data(), known_ * values_.rows());
}

}  // namespace fde
