// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/records/external_trajectory.hpp"

namespace fde::bench {

// The measurements that are not missing, with their deviations.
class Weighted {
 public:
  Weighted(const ExternalTrajectory& measured, const Rows& deviations)
      : measured_(measured), deviations_(deviations) {
    for (Eigen::Index i = 0; i < measured.values.cols(); ++i) {
      for (Eigen::Index c = 0; c < measured.values.rows(); ++c)
        if (!std::isnan(measured.values(c, i))) cells_.emplace_back(c, i);
    }
  }

  [[nodiscard]] Eigen::Index size() const { return std::ssize(cells_); }
  [[nodiscard]] Vec residuals(const Rows& model) const { return differences(model, measured_.values); }
  // (a - b) / deviation.
  [[nodiscard]] Vec differences(const Rows& a, const Rows& b) const {
    return vector([&](Eigen::Index c, Eigen::Index i) { return a(c, i) - b(c, i); })
        .cwiseQuotient(deviations());
  }
  [[nodiscard]] Vec deviations() const {
    return vector([&](Eigen::Index c, Eigen::Index i) { return deviations_(c, i); });
  }
  // |size of the column / deviation|, over all measurements.
  [[nodiscard]] double norm_of(const Vec& sizes) const {
    return vector([&](Eigen::Index c, Eigen::Index i) { return sizes[c] / deviations_(c, i); }).norm();
  }

 private:
  template <typename Value>
  [[nodiscard]] Vec vector(const Value& value) const {
    Vec made(size());
    for (Eigen::Index k = 0; const auto& [c, i] : cells_) made[k++] = value(c, i);
    return made;
  }

  const ExternalTrajectory& measured_;
  const Rows& deviations_;
  std::vector<std::pair<Eigen::Index, Eigen::Index>> cells_{};
};

}  // namespace fde::bench
