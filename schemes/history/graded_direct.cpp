#include "history/graded_direct.hpp"

#include <algorithm>

#include "weights/interval_weights.hpp"

namespace fde {

GradedDirectHistory::GradedDirectHistory(const WeightTables& tables, const Grid& grid)
    : grid_(grid), samples_(Matrix::Zero(grid.steps + 1, static_cast<Eigen::Index>(tables.front().size()))) {
  for (const auto& of_sum : tables) {
    auto& tracks = tracks_.emplace_back();
    for (std::size_t i = 0; i < of_sum.size(); ++i) {
      const double order = integral_order(of_sum[i]);
      if (order == 0.0) continue;  // L1 of order 1 has no past
      auto found = std::ranges::find(integrals_, order, &Integral::order);
      if (found == integrals_.end()) {
        found = integrals_.insert(found, {order, Vec(grid.steps), Vec(grid.steps)});
      }
      tracks.push_back(
          {static_cast<Eigen::Index>(i), of_sum[i], static_cast<std::size_t>(found - integrals_.begin())});
    }
  }
}

void GradedDirectHistory::push(In sample) {
  samples_.row(pushed_++) = sample;
  const double now = grid_.time(pushed_);
  for (auto& [order, left, right] : integrals_) {
    for (int j = 1; j <= pushed_; ++j) {
      const auto weights = interval_weights(order, now - grid_.time(j), grid_.step(j));
      left[j - 1] = weights.left;
      right[j - 1] = weights.right;
    }
  }
}

void GradedDirectHistory::convolve(std::size_t sum, Out result) const {
  result.setZero();
  for (const auto& [component, table, integral] : tracks_[sum]) {
    const auto& [order, left, right] = integrals_[integral];
    double total = 0.0;
    for (int j = 1; j <= pushed_; ++j) {  // the newest sample is still 0
      const auto [begin, end] =
          ends(table.family, samples_(j - 1, component), samples_(j, component), grid_.step(j));
      total += left[j - 1] * begin + right[j - 1] * end;
    }
    result[component] = total * integrals_to_sums(table, grid_.step(pushed_));
  }
}

std::size_t GradedDirectHistory::bytes() const {
  Eigen::Index doubles = samples_.size();
  for (const auto& integral : integrals_) doubles += 2 * integral.left.size();
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

}  // namespace fde
