// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/shown_equations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

namespace fde::bench {
namespace {

// The terms that a factor multiplies are written on the right.
EquationFormula written(const UnknownText& unknown) {
  EquationFormula equation{.unknown = unknown.name, .terms = {}, .rhs = unknown.rhs.text, .initial = {}};
  std::vector<std::string> multiplied;
  for (const auto& [coefficient, order] : unknown.terms) {
    if (unknown.factor && !equation.terms.empty()) {
      multiplied.push_back(fmt::format("{}*D({},{})", coefficient.text, unknown.name, order.text));
    } else {
      equation.terms.push_back({coefficient.text, order.text});
    }
  }
  if (!multiplied.empty()) {
    equation.rhs += fmt::format(" - ({})*({})", unknown.factor->text, fmt::join(multiplied, " + "));
  }
  for (const auto& value : unknown.initial) equation.initial.push_back(value.text);
  for (const auto& [column, position, value] : unknown.final) equation.final.emplace_back(column, value.text);
  return equation;
}

// The equation of an unknown that is no sum of Caputo derivatives.
DisplayEquation displayed(const UnknownText& unknown) {
  if (unknown.transfer)
    return {unknown.name, fmt::format("({})*({})", unknown.transfer->text, unknown.rhs.text)};
  DisplayEquation equation = displayed(written(unknown));
  if (unknown.is_riemann_liouville)
    equation.left = fmt::format("D_RL({},{})", unknown.name, unknown.terms.front().order.text);
  for (const auto& [weight, from, to] : unknown.distributed) {
    equation.left += fmt::format("{}int_{}^{} ({})*D({},q) dq", equation.left.empty() ? "" : " + ", from.text,
                                 to.text, weight.text, unknown.name);
  }
  return equation;
}

}  // namespace

void set_equations(const std::vector<UnknownText>& unknowns, SceneFactory& factory) {
  const auto is_sum = [](const UnknownText& one) {
    return !one.transfer && !one.size && one.distributed.empty() && !one.is_riemann_liouville;
  };
  if (std::ranges::all_of(unknowns, is_sum)) {
    for (const auto& unknown : unknowns) factory.equations.push_back(written(unknown));
  } else {
    for (const auto& unknown : unknowns) factory.display_equations.push_back(displayed(unknown));
  }
}

}  // namespace fde::bench
