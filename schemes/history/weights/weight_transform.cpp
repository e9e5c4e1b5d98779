// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/weight_transform.hpp"

namespace fde {
namespace {

template <typename Coefficient>
Vec transformed(Coefficient coefficient, double order, const ExponentialSum& sum) {
  return sum.nodes.binaryExpr(sum.coefficients,
                              [&](double node, double kernel) { return coefficient(order, node, kernel); });
}

}  // namespace

long double kernel_exponent(const WeightTable& table) {
  if (table.family->exponent != nullptr) return table.family->exponent(table.order);
  if (table.family->acts_on_increments) return 1.0L - table.order;
  return acts_on_running_sums(table) ? table.order - 1.0 : table.order;
}

bool acts_on_running_sums(const WeightTable& table) {
  return table.order > 1.0 && table.family->exponent == nullptr;
}

bool has_exponential_sum(const WeightTable& table) {
  const auto& family = *table.family;
  return family.coefficient != nullptr || family.filter != nullptr || family.smooth_part != nullptr;
}

Vec weight_coefficients(const WeightTable& table, const ExponentialSum& sum) {
  return transformed(table.family->coefficient, table.order, sum);
}

Vec first_sample_coefficients(const WeightTable& table, const ExponentialSum& sum) {
  return transformed(table.family->first_sample_coefficient, table.order, sum);
}

}  // namespace fde
