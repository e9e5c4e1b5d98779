// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/weights.hpp"

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

}  // namespace fde
