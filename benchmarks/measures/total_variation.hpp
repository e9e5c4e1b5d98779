// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {

// The scaled total variation of each column y of a solution up to a time: sum_k |y_k - y_{k-1}| / divisor.
class TotalVariation {
 public:
  // values, divisors: one row a column of the scene, one column a time. Precondition: the times increase
  // from 0.
  TotalVariation(std::vector<double> times, const Rows& values, const Rows& divisors);

  // Error that a maximum over the grid times misses: if one step of the grid contains most of a column's
  // variation (a transient inside the step), half of that variation; otherwise 0. One entry a column.
  // A solution ~ t^g, g the smallest order, has the fraction h^g of its variation in a first step h of an
  // interval 1, which is no transient; "most" is therefore more than min(0.9, (1 + h^g)/2).
  [[nodiscard]] Vec unresolved_variation(const Grid& grid, double smallest_order) const;

 private:
  [[nodiscard]] double variation_until(double t, Eigen::Index column) const;
  [[nodiscard]] double median_time(Eigen::Index column) const;

  std::vector<double> times_;
  Rows variation_;
};

// What the maximum error of a run over the grid misses, on each scale in the order of Scale, by the variation
// of the reference at times that do not depend on the grid. Empty where the reference is not known or not
// finite there.
std::array<Vec, error_scales.size()> unresolved_variations(const Problem& problem,
                                                           MemoizedReference& reference, const Grid& grid);

}  // namespace fde::bench
