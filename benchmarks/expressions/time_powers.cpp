// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/time_powers.hpp"

#include <cmath>

#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"

namespace fde::bench {
namespace {

// Whether the operation of a node is smooth at the arguments a, b.
bool is_smooth(const ExpressionPool::Node& node, double a, double b) {
  switch (node.operation) {
    case Operation::divide:
      return b != 0.0;
    case Operation::power:
    case Operation::log:
    case Operation::sqrt:
    case Operation::abs:
    case Operation::sign:
    case Operation::step:
      return a != 0.0;
    case Operation::asin:
    case Operation::acos:
      return std::abs(a) != 1.0;
    case Operation::atan2:
      return a != 0.0 || b != 0.0;
    case Operation::min:
    case Operation::max:
      return a != b;
    case Operation::sampled:
      return node.function->is_smooth_at(a);
    default:
      return true;
  }
}

}  // namespace

std::optional<double> power_of_time(const ExpressionPool& pool, const ExpressionPool::Node& entry) {
  const bool of_time = entry.arguments[0] != ExpressionPool::none &&
                       pool[entry.arguments[0]].operation == Operation::variable &&
                       pool[entry.arguments[0]].variable == 0;
  if (!of_time) return std::nullopt;
  if (entry.operation == Operation::sqrt) return 0.5;
  if (entry.operation != Operation::power || pool[entry.arguments[1]].operation != Operation::number)
    return std::nullopt;
  const auto power = static_cast<double>(pool[entry.arguments[1]].value);
  return power > 0.0 ? std::optional(power) : std::nullopt;
}

std::vector<double> values_of_parts(const ExpressionPool& pool, const std::vector<Expression>& of, In start) {
  const auto used = pool.subexpressions(of);
  std::vector<Expression> parts;
  for (std::size_t e = 0; e < used.size(); ++e)
    if (used[e]) parts.push_back(static_cast<Expression>(e));
  std::vector<double> of_parts(parts.size()), values(used.size(), 0.0);
  Program(pool, parts, start.size()).evaluate(0.0, start, of_parts);
  for (std::size_t i = 0; i < parts.size(); ++i) values[static_cast<std::size_t>(parts[i])] = of_parts[i];
  return values;
}

namespace {

// Whether it is constant after t = 0: its argument is no whole number there, or a function of t that
// increases.
bool floor_is_smooth(const ExpressionPool& pool, Expression argument, double at_start) {
  constexpr double soon = 0x1p-40;
  if (at_start != std::floor(at_start)) return true;
  return !pool.depends_on_unknowns(argument) && Program(pool, {argument}, 0)(soon, Vec()) > at_start;
}

}  // namespace

std::optional<std::set<double>> time_powers(const ExpressionPool& pool, Expression of,
                                            const std::vector<double>& values) {
  std::set<double> powers;
  for (const auto e : pool.parts({of})) {
    const auto& entry = pool[e];
    if (entry.arguments[0] == ExpressionPool::none) continue;
    if (const auto power = power_of_time(pool, entry)) {
      powers.insert(*power);
      continue;
    }
    const auto at = [&](std::size_t i) {
      return entry.arguments[i] == ExpressionPool::none
                 ? 0.0
                 : values[static_cast<std::size_t>(entry.arguments[i])];
    };
    const bool smooth = entry.operation == Operation::floor ? floor_is_smooth(pool, entry.arguments[0], at(0))
                                                            : is_smooth(entry, at(0), at(1));
    if (!smooth && !pool.variables_in(e).empty()) return std::nullopt;
  }
  return powers;
}

std::optional<std::set<double>> powers_of_time(const ExpressionPool& pool, const std::vector<Expression>& of,
                                               In start) {
  const auto values = values_of_parts(pool, of, start);
  std::set<double> all;
  for (const auto e : of) {
    const auto powers = time_powers(pool, e, values);
    if (!powers) return std::nullopt;
    all.insert(powers->begin(), powers->end());
  }
  return all;
}

}  // namespace fde::bench
