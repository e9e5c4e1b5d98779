// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/instructions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

#include "fdebench/benchmarks/expressions/apply.hpp"

namespace fde::bench {

namespace {

std::string operation_text(Operation operation, const std::array<std::string_view, 3>& arguments) {
  constexpr std::string_view symbols = "+-*/";
  if (operation == Operation::pi) return formula_number(std::numbers::pi);
  if (operation == Operation::negate) return fmt::format("(-{})", arguments[0]);
  const auto symbol = static_cast<std::size_t>(operation) - static_cast<std::size_t>(Operation::add);
  if (symbol < symbols.size()) return fmt::format("({}{}{})", arguments[0], symbols[symbol], arguments[1]);
  const auto& [name, count, is_function] = signature(operation);
  return fmt::format("{}({})", name, fmt::join(std::span(arguments).first(count), ","));
}

}  // namespace

InstructionList instructions_of(const ExpressionPool& pool, const std::vector<Expression>& results,
                                const std::vector<Eigen::Index>& places, Eigen::Index size) {
  InstructionList list{.inputs = static_cast<int>(size) + 1, .places = places};
  const auto used = pool.subexpressions(results);
  std::vector<int> slots(used.size(), 0);
  for (std::size_t e = 0; e < used.size(); ++e) {
    const auto& entry = pool[static_cast<Expression>(e)];
    if (!used[e] || entry.operation != Operation::number) continue;
    slots[e] = list.first();
    list.numbers.push_back(static_cast<double>(entry.value));
  }
  for (std::size_t e = 0; e < used.size(); ++e) {
    const auto& entry = pool[static_cast<Expression>(e)];
    if (!used[e] || entry.operation == Operation::number) continue;
    if (entry.operation == Operation::variable) {
      slots[e] = entry.variable;
      continue;
    }
    slots[e] = static_cast<int>(list.slots());
    const auto slot = [&](std::size_t i) {
      return entry.arguments[i] == ExpressionPool::none ? 0
                                                        : slots[static_cast<std::size_t>(entry.arguments[i])];
    };
    list.instructions.push_back({entry.operation, slot(0), slot(1), slot(2), entry.function.get()});
    if (entry.function) list.functions.push_back(entry.function);
  }
  for (const auto result : results) list.results.push_back(slots[static_cast<std::size_t>(result)]);
  return list;
}

void interpret(const InstructionList& list, double t, const double* y, std::span<double> results) {
  constexpr std::size_t usual = 256;
  std::array<double, usual>
      few;  // NOLINT(cppcoreguidelines-pro-type-member-init): all that is read is written
  std::vector<double> many(list.slots() > usual ? list.slots() : 0);
  double* const values = many.empty() ? few.data() : many.data();
  values[0] = t;
  std::copy_n(y, list.inputs - 1, values + 1);
  double* next = std::ranges::copy(list.numbers, values + list.inputs).out;
  for (const auto& [operation, a, b, c, function] : list.instructions)
    *next++ = apply<double>(operation, values[a], values[b], values[c], function);
  for (std::size_t i = 0; i < list.results.size(); ++i)
    results[static_cast<std::size_t>(list.places[i])] = values[list.results[i]];
}

void interpret(const InstructionList& list, const Interval& t, const Interval* y,
               std::span<Interval> results) {
  std::vector<Interval> values(list.slots());
  values[0] = t;
  std::copy_n(y, list.inputs - 1, values.begin() + 1);
  auto next = std::ranges::copy(list.numbers, values.begin() + list.inputs).out;
  for (const auto& [operation, a, b, c, function] : list.instructions) {
    const auto at = [&](int slot) { return values[static_cast<std::size_t>(slot)]; };
    // Both factors are the same number: x x has no negative values.
    *next++ = operation == Operation::multiply && a == b
                  ? square(at(a))
                  : apply<Interval>(operation, at(a), at(b), at(c), function);
  }
  for (std::size_t i = 0; i < list.results.size(); ++i)
    results[static_cast<std::size_t>(list.places[i])] = values[static_cast<std::size_t>(list.results[i])];
}

// A whole number has a point too: 1/2 is 0 in C, and 1*x is no expression in Rust.
std::string formula_number(double value) {
  auto text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return value < 0.0 ? fmt::format("({})", text) : text;
}

std::vector<std::string> texts_of(const InstructionList& list) {
  constexpr std::size_t most_bytes = std::size_t{1} << 20;
  if (!list.functions.empty()) return {};
  if (!std::ranges::all_of(list.numbers, [](double value) { return std::isfinite(value); })) return {};
  std::vector<std::string> texts{"t"};
  for (int i = 1; i < list.inputs; ++i) texts.push_back(fmt::format("y{}", i));
  for (const double value : list.numbers) texts.push_back(formula_number(value));
  const auto text = [&](int slot) -> const std::string& { return texts[static_cast<std::size_t>(slot)]; };
  for (const auto& [operation, a, b, c, function] : list.instructions) {
    texts.push_back(operation_text(operation, {text(a), text(b), text(c)}));
    if (texts.back().size() > most_bytes) return {};
  }
  std::vector<std::string> results;
  std::size_t bytes = 0;
  for (const int slot : list.results) {
    results.push_back(text(slot));
    bytes += results.back().size();
  }
  return bytes > most_bytes ? std::vector<std::string>{} : results;
}

}  // namespace fde::bench
