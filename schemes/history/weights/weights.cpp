// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/weights.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

namespace {

long double extended_weight(const WeightTable& table, std::int64_t lag) {
  return table.family->weight(table.order, static_cast<long double>(lag));
}

}  // namespace

double weight(const WeightTable& table, std::int64_t lag) {
  return static_cast<double>(extended_weight(table, lag));
}

double weight_increment(const WeightTable& table, std::int64_t lag) {
  return static_cast<double>(extended_weight(table, lag) - (lag == 1 ? 0 : extended_weight(table, lag - 1)));
}

Vec first_weights(const WeightTable& table, Eigen::Index count) {
  if (table.family->first_weights == nullptr)
    return Vec::NullaryExpr(count, [&](Eigen::Index k) { return weight(table, k + 1); });
  const auto extended = table.family->first_weights(table.order, static_cast<std::size_t>(count));
  return Vec::NullaryExpr(
      count, [&](Eigen::Index k) { return static_cast<double>(extended[static_cast<std::size_t>(k)]); });
}

std::optional<double> constant_weight(const WeightTable& table) {
  if (table.order == 0.0) return 0.0;
  return table.order == 1.0 ? table.family->weight_at_order_one : std::nullopt;
}

std::optional<double> first_sample_weight(const WeightTable& table, std::int64_t n) {
  if (table.family->first_sample_weight == nullptr) return std::nullopt;
  return static_cast<double>(table.family->first_sample_weight(table.order, static_cast<long double>(n)));
}

double step_factor(const WeightTable& table, double length) {
  return static_cast<double>(table.family->step_factor(table.order) * std::pow(length, table.order));
}

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
