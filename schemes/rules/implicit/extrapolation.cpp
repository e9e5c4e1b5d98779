// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdebench/schemes/history/parallel_for_rows.hpp"

namespace fde {
namespace {

// The weights for n points at equal distances, (-1)^(k-1) n! / (k! (n-k)!) of the k-th newest.
template <std::size_t points>
constexpr auto weights_at_equal_distances = [] {
  std::array<std::array<double, points>, points + 1> all{};
  for (std::size_t n = 1; n <= points; ++n) {
    double binomial = -1.0;
    for (std::size_t k = 1; k <= n; ++k) {
      binomial *= -static_cast<double>(n - k + 1) / static_cast<double>(k);
      all[n][k - 1] = binomial;
    }
  }
  return all;
}();

}  // namespace

void Extrapolation::push(double t, In y) {
  equal_count_ = continues_equal_distances(t) ? std::min(equal_count_ + 1, max_points) : 2;
  if (point_count_ > 0) newest_ = (newest_ + 1) % max_points;
  point_count_ = std::min(point_count_ + 1, max_points);
  times_[static_cast<std::size_t>(newest_)] = t;
  double* const newest = values_.col(newest_).data();
  for_each_row(y.size(), [&](Eigen::Index i) { newest[i] = y.coeff(i); });
}

bool Extrapolation::continues_equal_distances(double t) const {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * t;
  return equal_count_ < 2 || std::abs((t - time(0)) - (time(0) - time(1))) <= rounding;
}

Extrapolation::Weights Extrapolation::weights(double t, int count) const {
  if (count <= equal_count_ && continues_equal_distances(t))
    return weights_at_equal_distances<max_points>[static_cast<std::size_t>(count)];
  Weights weights{};
  for (int i = 0; i < count; ++i) {
    double above = 1.0, below = 1.0;
    for (int j = 0; j < count; ++j) {
      if (j == i) continue;
      above *= t - time(j);
      below *= time(i) - time(j);
    }
    weights[static_cast<std::size_t>(i)] = above / below;
  }
  return weights;
}

// The weights of points that are not used are 0. The newest point is added last: its values have just become
// known.
void Extrapolation::at(double t, Out value) const {
  const Weights weights = this->weights(t, std::min(chosen_count_, point_count_));
  std::array<const double*, max_points> points{};
  for (int age = 0; age < max_points; ++age)
    points[static_cast<std::size_t>(age)] = values_.data() + column(age) * values_.rows();
  for_each_row(value.size(), [=, result = value.data()](Eigen::Index i) {
    double sum = weights[max_points - 1] * points[max_points - 1][i];
    for (std::size_t age = max_points - 1; age-- > 0;) sum += weights[age] * points[age][i];
    result[i] = sum;
  });
}

void Extrapolation::choose_count(double t, In value, In scale) {
  Vec extrapolated(value.size());
  double smallest = std::numeric_limits<double>::infinity();
  int best = 1;
  for (int count = 1; count <= point_count_; ++count) {
    chosen_count_ = count;
    at(t, extrapolated);
    const double error = (scale.array() * (extrapolated - value).array()).abs().maxCoeff();
    if (error < smallest) {
      smallest = error;
      best = count;
    }
  }
  chosen_count_ = best;
}

void Extrapolation::state(Archive& archive) {
  archive.count(point_count_, 0, max_points);
  archive.count(newest_, 0, max_points - 1);
  archive.count(equal_count_, 0, max_points);
  archive.count(chosen_count_, 1, max_points);
  archive(times_);
  archive.values(values_.data(), point_count_ * values_.rows());
}

}  // namespace fde
