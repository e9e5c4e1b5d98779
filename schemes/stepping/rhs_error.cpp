// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/rhs_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace fde {
namespace {

// +1 or -1, the same in every run. The signs of two rows differ in half of the trials.
double sign(Eigen::Index row, int trial) {
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15, other = 0xbf58476d1ce4e5b9;
  std::uint64_t bits = (static_cast<std::uint64_t>(row) * 16 + static_cast<std::uint64_t>(trial)) * odd;
  bits = (bits ^ (bits >> 30U)) * other;
  return (bits >> 32U) % 2 == 0 ? 1.0 : -1.0;
}

}  // namespace

void RhsError::measure(const std::function<const Vec&(In y)>& f, In y, In permitted) {
  constexpr int trials_of_rounding = 8, most_bits = 6;
  constexpr double unit = std::numeric_limits<double>::epsilon(), above_largest = 10.0;
  const Vec unmoved = f(y);
  Vec moved = y;
  const auto add = [&](Vec& largest, double factor) {
    const Vec change = factor * (f(moved) - unmoved).cwiseAbs();
    largest = largest.cwiseMax(change.unaryExpr([](double v) { return std::isfinite(v) ? v : 0.0; }));
  };
  rounding_ /= 2.0;
  inherited_ /= 2.0;
  for (int trial = 0; trial < trials_of_rounding; ++trial) {
    const int size = 1 + trial / 2;
    const double part = size * unit;
    for (Eigen::Index i = 0; i < y.size(); ++i) moved[i] = y[i] * (1.0 + sign(i, trial) * part);
    add(rounding_, above_largest);
  }
  // For each two rows one of these sets of rows contains the first and not the second.
  for (int bit = 0; bit < most_bits && (Eigen::Index{1} << bit) < y.size(); ++bit) {
    for (const Eigen::Index side : {0, 1}) {
      const auto is_moved = [&](Eigen::Index i) { return ((i >> bit) & 1) == side; };
      for (Eigen::Index i = 0; i < y.size(); ++i)
        moved[i] = is_moved(i) ? y[i] + sign(i, bit) * permitted[i] : y[i];
      Vec change = Vec::Zero(y.size());
      add(change, 1.0);
      for (Eigen::Index i = 0; i < y.size(); ++i)
        if (!is_moved(i)) inherited_[i] = std::max(inherited_[i], change[i]);
    }
  }
  is_measured_ = true;
}

}  // namespace fde
