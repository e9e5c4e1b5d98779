// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/step_factors.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

StepFactors::StepFactors(const std::vector<WeightTable>& tables) : factors_(std::ssize(tables)) {
  for (const auto& table : tables) {
    const auto found = std::ranges::find(distinct_, table, &Table::table);
    of_row_.push_back(found - distinct_.begin());
    if (found != distinct_.end()) continue;
    const auto order = std::ranges::find(orders_, table.order);
    distinct_.push_back({table, order - orders_.begin(), table.family->step_factor(table.order)});
    if (order == orders_.end()) orders_.push_back(table.order);
  }
  powers_.resize(std::ssize(orders_));
}

void StepFactors::compute(double length) {
  length_ = length;
  for (Eigen::Index k = 0; k < powers_.size(); ++k)
    powers_[k] = std::pow(length, orders_[static_cast<std::size_t>(k)]);
  Vec of_table(std::ssize(distinct_));
  for (Eigen::Index k = 0; k < of_table.size(); ++k) {
    const auto& [table, order, unit] = distinct_[static_cast<std::size_t>(k)];
    of_table[k] = static_cast<double>(unit * powers_[order]);
  }
  for (std::size_t i = 0; i < of_row_.size(); ++i)
    factors_[static_cast<Eigen::Index>(i)] = of_table[of_row_[i]];
}

double StepFactors::power(double exponent) const {
  const auto found = std::ranges::find(orders_, exponent);
  return found == orders_.end() ? std::pow(length_, exponent) : powers_[found - orders_.begin()];
}

}  // namespace fde
