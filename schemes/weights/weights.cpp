#include "weights/weights.hpp"

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

std::optional<double> constant_weight(const WeightTable& table) {
  return table.order == 1.0 ? table.family->weight_at_order_one : std::nullopt;
}

std::optional<double> start_weight(const WeightTable& table, std::int64_t n) {
  if (table.family->start_weight == nullptr) return std::nullopt;
  return static_cast<double>(table.family->start_weight(table.order, static_cast<long double>(n)));
}

double step_factor(const WeightTable& table, double length) {
  return table.family->step_factor(table.order, std::pow(length, table.order));
}

}  // namespace fde
