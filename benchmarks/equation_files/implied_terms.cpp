// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/implied_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fdebench/benchmarks/equation_files/file_formulas.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {
namespace {

// The orders of the terms of an unknown whose coefficient is not 0; empty where no term may be added.
std::vector<double> orders_of(const UnknownText& unknown, FileFormulas& formulas) {
  std::vector<double> orders;
  if (unknown.factor || !unknown.is_chain) return orders;
  for (const auto& term : unknown.terms) {
    if (formulas.constant(term.coefficient, "coefficient", any_number) != 0.0)
      orders.push_back(formulas.constant(term.order, "order", any_number));
  }
  return orders;
}

bool is_implied(const std::vector<double>& orders, double order) {
  const bool is_whole = order == std::floor(order);
  const auto is_same = [=](double one) { return same_order(one, order); };
  return !is_whole && std::ranges::none_of(orders, is_same) &&
         std::ranges::any_of(orders, [=](double one) { return order > 0.0 && order < one; });
}

}  // namespace

EquationText with_implied_terms(EquationText text, const Parameters& parameters) {
  struct Derivative {
    std::size_t unknown;
    double order;
    bool operator==(const Derivative&) const = default;
  };
  const auto names_derivative = [](const UnknownText& one) {
    return one.rhs.text.find("D(") != std::string::npos;
  };
  if (std::ranges::none_of(text.unknowns, names_derivative)) return text;
  FileFormulas formulas(text, parameters, NumberStorage::values);
  std::vector<Derivative> derivatives;  // number i is variable i + 1
  const FormulaVariables variables{.time = true, .resolve_unknown = [&](std::size_t unknown, double order) {
                                     const Derivative one{unknown, order};
                                     const auto known = std::ranges::find(derivatives, one);
                                     const auto number = static_cast<int>(known - derivatives.begin());
                                     if (known == derivatives.end()) derivatives.push_back(one);
                                     return formulas.pool().variable(number + 1);
                                   }};
  std::vector<Expression> sides;
  for (const auto& unknown : text.unknowns) sides.push_back(formulas.read(unknown.rhs, variables));
  EquationText complete = text;
  for (std::size_t i = 0; i < derivatives.size(); ++i) {
    const auto& [number, order] = derivatives[i];
    const auto is_there = [&](Expression side) {
      return formulas.pool().depends_on(side, static_cast<int>(i) + 1);
    };
    if (!is_implied(orders_of(text.unknowns[number], formulas), order) ||
        std::ranges::none_of(sides, is_there))
      continue;
    auto& unknown = complete.unknowns[number];
    const auto position = unknown.rhs.position;
    unknown.terms.push_back(
        {{.text = "1", .position = position}, {.text = fmt::format("{}", order), .position = position}});
    unknown.rhs.text += fmt::format(" + D({}, {})", unknown.name, order);
  }
  return complete;
}

}  // namespace fde::bench
