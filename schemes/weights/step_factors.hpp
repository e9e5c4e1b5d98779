#pragma once

#include <vector>

#include "weights/weights.hpp"

namespace fde {

// The step factors of several tables for a step of any length, one after the other: Gamma functions are
// computed once, a power once for each order, and nothing where the length is that of the last call.
class StepFactors {
 public:
  explicit StepFactors(const std::vector<WeightTable>& tables);

  // One a table, in their order. Valid until the next call.
  const Vec& at(double length);

  // A power of the length of the last call; those of the orders are known.
  [[nodiscard]] double power(double exponent) const;

 private:
  std::vector<double> orders_;        // without repetition
  std::vector<Eigen::Index> of_row_;  // which of them each table has
  double length_ = 0.0;               // of the last call
  std::vector<long double> units_;
  Vec powers_, factors_;
};

}  // namespace fde
