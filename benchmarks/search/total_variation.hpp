#pragma once

#include <vector>

#include "problem/grid.hpp"
#include "stepping/trajectory.hpp"

namespace fde {

// The total variation of each column of a solution up to a time: the sum of its changes, each over a divisor.
class TotalVariation {
 public:
  // values, divisors: a row a column of the scene, a column for each of the times, which increase from 0.
  TotalVariation(std::vector<double> times, const Rows& values, const Rows& divisors);

  // Half of the variation of a column within one step of the grid, where that step has most of it; 0 where
  // there is no such step. A maximum over the times of the grid does not see it. A solution that moves as
  // t^g, g the smallest order, has the part h^g of its variation within a first step h of an interval 1,
  // which is no transient: a step has most where it has more than (1 + h^g)/2 of it, at most nine tenths.
  [[nodiscard]] double hidden_by(const Grid& grid, double smallest_order) const;

 private:
  [[nodiscard]] double up_to(double t, Eigen::Index column) const;
  [[nodiscard]] double half_way(Eigen::Index column) const;

  std::vector<double> times_;
  Rows variation_;
};

}  // namespace fde
