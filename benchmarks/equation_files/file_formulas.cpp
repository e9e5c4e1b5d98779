// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/file_formulas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "fdebench/benchmarks/expressions/formula.hpp"

namespace fde::bench {
namespace {

std::optional<std::size_t> unknown_named(const EquationText& text, std::string_view name) {
  const auto found = std::ranges::find(text.unknowns, name, &UnknownText::name);
  if (found == text.unknowns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - text.unknowns.begin());
}

}  // namespace

Expression FileFormulas::read(const FormulaText& formula, const FormulaVariables& variables) {
  FormulaNames names;
  if (variables.time) names.accepted_names.emplace_back("t");
  for (const auto& parameter : text_.parameters) names.accepted_names.emplace_back(parameter.name);
  if (variables.resolve_unknown) {
    for (const auto& unknown : text_.unknowns) names.accepted_names.emplace_back(unknown.name);
    names.derivative = [&](std::string_view unknown, Expression order) {
      return derivative(unknown, order, variables);
    };
  }
  names.resolve = [&](std::string_view name) -> std::optional<Expression> {
    if (name == "t" && variables.time) return pool_.variable(0);
    if (std::ranges::find(text_.parameters, name, &ParameterText::name) != text_.parameters.end())
      return pool_.number(fmt::format("{}", parameters_[name]));
    const auto unknown = unknown_named(text_, name);
    if (!unknown || !variables.resolve_unknown) return std::nullopt;
    return variables.resolve_unknown(*unknown, 0.0);
  };
  try {
    return read_formula(formula.text, names, pool_);
  } catch (const FormulaError& fault) {
    reject_in(text_.file, formula, fault.byte_offset, fault.what());
  } catch (const std::invalid_argument& fault) {
    reject(formula, fault.what());
  }
}

Expression FileFormulas::derivative(std::string_view unknown, Expression order,
                                    const FormulaVariables& variables) {
  const auto found = unknown_named(text_, unknown);
  if (!found) throw std::invalid_argument(fmt::format("{}: must be an unknown, as in D(x, 0.5)", unknown));
  const auto value = pool_.value(order);
  if (!value || !std::isfinite(static_cast<double>(*value)))
    throw std::invalid_argument("D: its order must be a formula of the parameters");
  return variables.resolve_unknown(*found, static_cast<double>(*value));
}

double FileFormulas::constant(const FormulaText& formula, std::string_view name, const Range& allowed) {
  const auto read_value = pool_.value(read(formula, {.time = false}));
  const auto value = static_cast<double>(read_value.value());
  if (!allowed.contains(value))
    reject(formula, fmt::format("{} = {}: must be {}", name, value, allowed.text()));
  return value;
}

}  // namespace fde::bench
