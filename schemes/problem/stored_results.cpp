// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/stored_results.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace fde {
namespace {

// The weight of the value at times[k] in the polynomial through the values at all of them (Lagrange).
double lagrange_weight(const std::vector<double>& times, std::size_t first, std::size_t count, std::size_t k,
                       double t) {
  double weight = 1.0;
  for (std::size_t j = first; j < first + count; ++j)
    if (j != k) weight *= (t - times[j]) / (times[k] - times[j]);
  return weight;
}

}  // namespace

StoredResults::StoredResults(In start, std::vector<double> breaking_points)
    : size_(start.size()),
      results_(start.begin(), start.end()),
      breaking_points_(std::move(breaking_points)) {}

void StoredResults::add(double t, In y) {
  times_.push_back(t);
  results_.insert(results_.end(), y.begin(), y.end());
}

Eigen::Map<const Vec> StoredResults::result(std::size_t n) const {
  return {results_.data() + static_cast<Eigen::Index>(n) * size_, size_};
}

Vec StoredResults::at(double t) const {
  constexpr std::size_t most = 8;
  constexpr double rounding = 1e-13;  // of a time
  const auto index_from = [&](double time) {
    return static_cast<std::size_t>(std::ranges::lower_bound(times_, time) - times_.begin());
  };
  const std::size_t next = std::min(index_from(t), times_.size() - 1);
  if (times_[next] == t || next == 0) return result(next);
  // The smooth interval around the step that contains t.
  const double middle = 0.5 * (times_[next - 1] + times_[next]);
  const auto after = std::ranges::upper_bound(breaking_points_, middle);
  const std::size_t begin =
      after == breaking_points_.begin() ? 0 : index_from(*std::prev(after) * (1.0 - rounding));
  const std::size_t end = after == breaking_points_.end()
                              ? times_.size()
                              : std::min(index_from(*after * (1.0 + rounding)), times_.size());
  const std::size_t low = std::min(begin, next - 1), high = std::max(end, next + 1);
  const std::size_t count = std::min(most, high - low);
  const std::size_t first = std::clamp(next, low + count / 2, high - count + count / 2) - count / 2;
  Vec y = Vec::Zero(size_);
  for (std::size_t k = first; k < first + count; ++k)
    y += lagrange_weight(times_, first, count, k, t) * result(k);
  return y;
}

void StoredResults::state(Archive& archive) {
  archive.resizable(times_);
  archive.resizable(results_);
}

}  // namespace fde
