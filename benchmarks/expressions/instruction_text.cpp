// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/instruction_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace fde::bench {
namespace {

// The symbol of an operation between two arguments; 0: it is written as a call.
char symbol(Operation operation) {
  switch (operation) {
    case Operation::add:
      return '+';
    case Operation::subtract:
      return '-';
    case Operation::multiply:
      return '*';
    case Operation::divide:
      return '/';
    default:
      return 0;
  }
}

std::string call_text(Operation operation, const std::array<std::string_view, 3>& arguments) {
  if (operation == Operation::power) return fmt::format("power({},{})", arguments[0], arguments[1]);
  const auto function = std::ranges::find(function_table(), operation, &FunctionSignature::operation);
  auto text = fmt::format("{}({}", function->name, arguments[0]);
  for (std::size_t i = 1; i < function->arguments; ++i) text += fmt::format(",{}", arguments[i]);
  return text + ')';
}

std::string operation_text(Operation operation, const std::array<std::string_view, 3>& arguments) {
  if (operation == Operation::pi) return formula_number(std::numbers::pi);
  if (operation == Operation::negate) return fmt::format("(-{})", arguments[0]);
  if (const char between = symbol(operation))
    return fmt::format("({}{}{})", arguments[0], between, arguments[1]);
  return call_text(operation, arguments);
}

}  // namespace

// A whole number has a point too: 1/2 is 0 in C, and 1*x is no expression in Rust.
std::string formula_number(double value) {
  auto text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return value < 0.0 ? fmt::format("({})", text) : text;
}

std::vector<std::string> texts_of(const InstructionList& list) {
  constexpr std::size_t most_bytes = std::size_t{1} << 20;
  if (!std::ranges::all_of(list.numbers, [](double value) { return std::isfinite(value); })) return {};
  std::vector<std::string> texts{"t"};
  for (int i = 1; i < list.inputs; ++i) texts.push_back(fmt::format("y{}", i));
  for (const double value : list.numbers) texts.push_back(formula_number(value));
  const auto text = [&](int slot) -> const std::string& { return texts[static_cast<std::size_t>(slot)]; };
  for (const auto& [operation, a, b, c] : list.instructions) {
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
