// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/total_variation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"

namespace fde::bench {

TotalVariation::TotalVariation(std::vector<double> times, const Rows& values, const Rows& divisors)
    : times_(std::move(times)), variation_(Rows::Zero(values.rows(), values.cols())) {
  for (Eigen::Index c = 1; c < values.cols(); ++c) {
    variation_.col(c) =
        variation_.col(c - 1) + (values.col(c) - values.col(c - 1))
                                    .cwiseAbs()
                                    .cwiseQuotient(divisors.col(c).cwiseMax(divisors.col(c - 1)));
  }
}

Vec TotalVariation::unresolved_variation(const Grid& grid, double smallest_order) const {
  constexpr double nine_tenths = 0.9;
  Vec hidden = Vec::Zero(variation_.rows());
  for (Eigen::Index column = 0; column < variation_.rows(); ++column) {
    // Only the step that contains the median of the variation can have more than half of it.
    const double place = grid.steps * std::pow(median_time(column) / grid.end, 1.0 / grid.grading);
    const int step = std::clamp(static_cast<int>(std::ceil(place)), 1, grid.steps);
    const double from = grid.time(step - 1), to = grid.time(step);
    const double within = variation_until(to, column) - variation_until(from, column);
    const double most = std::min(nine_tenths, 0.5 * (1.0 + std::pow((to - from) / grid.end, smallest_order)));
    if (within > most * variation_(column, variation_.cols() - 1)) hidden[column] = 0.5 * within;
  }
  return hidden;
}

// Linear interpolation between the given times.
double TotalVariation::variation_until(double t, Eigen::Index column) const {
  const auto next = std::ranges::upper_bound(times_, t);
  if (next == times_.end()) return variation_(column, variation_.cols() - 1);
  const auto c = next - times_.begin();
  const double part = (t - *(next - 1)) / (*next - *(next - 1));
  return std::lerp(variation_(column, c - 1), variation_(column, c), part);
}

// The first given time (after 0) with at least half of the column's variation.
double TotalVariation::median_time(Eigen::Index column) const {
  const auto row = variation_.row(column);
  const auto found = std::ranges::lower_bound(row, 0.5 * row[row.size() - 1]);
  return times_[static_cast<std::size_t>(std::max<Eigen::Index>(1, found - row.begin()))];
}

std::array<Vec, error_scales.size()> unresolved_variations(const Problem& problem,
                                                           MemoizedReference& reference, const Grid& grid) {
  constexpr int evenly = 64;
  const auto times = comparison_times(problem, evenly);
  std::array<Vec, error_scales.size()> found;
  try {
    const Rows values = reference.at(times);
    if (!values.allFinite()) return found;
    for (const Scale scale : error_scales) {
      const TotalVariation variation(times, values, divisors(scale, times, values));
      found.at(static_cast<std::size_t>(scale)) =
          variation.unresolved_variation(grid, smallest_order(problem));
    }
  } catch (const std::runtime_error&) {  // without a reference there is no error either
    return {};
  }
  return found;
}

}  // namespace fde::bench
