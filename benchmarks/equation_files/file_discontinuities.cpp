// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/file_discontinuities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace fde::bench {
namespace {

struct OrderedLimit {
  double order;
  Discontinuity found;
};

// The limit of a term whose order is the parameter of this name; nullopt if the term is continuous in it.
std::optional<OrderedLimit> limit_of(const EquationSystem::Unknown& unknown, Expression coefficient,
                                     const Parameter& parameter, double order, const ExpressionPool& pool) {
  const auto& initial = unknown.chain->initial();
  if (order != std::floor(order) || order >= unknown.chain->leading().order) return std::nullopt;
  if (parameter.range.high <= order) return std::nullopt;  // continuous from below
  const auto k = static_cast<std::size_t>(order);
  if (pool.value(coefficient) == 0.0L || initial[k] == 0.0) return std::nullopt;
  const bool has_smaller = parameter.range.low < order;
  const auto derivative = unknown.name + std::string(k, '\'');
  return OrderedLimit{
      order,
      {parameter.name, fmt::format("D^{} {} tends to {} - {}(0){}", parameter.name, unknown.name, derivative,
                                   derivative, has_smaller ? " from above" : "")}};
}

}  // namespace

std::vector<Discontinuity> file_discontinuities(const EquationSystem& system, FileFormulas& formulas) {
  std::vector<Discontinuity> all;
  for (std::size_t u = 0; u < system.unknowns.size(); ++u) {
    const auto& unknown = system.unknowns[u];
    const auto& terms = formulas.text().unknowns[u].terms;
    std::vector<OrderedLimit> limits;
    for (std::size_t k = 0; unknown.chain && k < terms.size(); ++k) {
      for (const auto& parameter : formulas.text().parameters) {
        if (parameter.declared.name != terms[k].order.text) continue;
        const double order = formulas.constant(terms[k].order, "order", any_number);
        if (auto limit =
                limit_of(unknown, unknown.coefficients[k], parameter.declared, order, formulas.pool()))
          limits.push_back(std::move(*limit));
      }
    }
    std::ranges::stable_sort(limits, {}, &OrderedLimit::order);
    for (auto& limit : limits) all.push_back(std::move(limit.found));
  }
  return all;
}

}  // namespace fde::bench
