// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/step_factors.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

StepFactors::StepFactors(const std::vector<WeightTable>& tables) : factors_(std::ssize(tables)) {
  for (const auto& [family, order] : tables) {
    const auto found = std::ranges::find(orders_, order);
    of_row_.push_back(found - orders_.begin());
    if (found == orders_.end()) orders_.push_back(order);
    units_.push_back(family->step_factor(order));
  }
  powers_.resize(std::ssize(orders_));
}

void StepFactors::compute(double length) {
  length_ = length;
  for (Eigen::Index k = 0; k < powers_.size(); ++k)
    powers_[k] = std::pow(length, orders_[static_cast<std::size_t>(k)]);
  for (std::size_t i = 0; i < units_.size(); ++i)
    factors_[static_cast<Eigen::Index>(i)] = static_cast<double>(units_[i] * powers_[of_row_[i]]);
}

double StepFactors::power(double exponent) const {
  const auto found = std::ranges::find(orders_, exponent);
  return found == orders_.end() ? std::pow(length_, exponent) : powers_[found - orders_.begin()];
}

}  // namespace fde
