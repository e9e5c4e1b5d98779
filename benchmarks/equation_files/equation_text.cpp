// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/equation_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "fdebench/benchmarks/equation_files/file_formulas.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {

namespace {

bool is_left_out(const ParameterValues& unless, const Parameters& parameters) {
  const auto holds = [&](const auto& condition) {
    return parameters.value(condition.first) == condition.second;
  };
  return !unless.empty() && std::ranges::all_of(unless, holds);
}

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

EquationText present_parts(EquationText text, const Parameters& parameters) {
  const auto left_out = [&](const auto& part) { return is_left_out(part.unless, parameters); };
  for (const auto& unknown : text.unknowns)
    if (left_out(unknown)) text.absent_unknowns.push_back(unknown.name);
  std::erase_if(text.unknowns, left_out);
  std::erase_if(text.columns, left_out);
  std::erase_if(text.requirements, left_out);
  return text;
}

void reject_at(const std::string& file, const TextPosition& place, std::string_view what) {
  constexpr std::size_t longest = 600;
  std::size_t shown = std::min(what.size(), longest);
  while (shown < what.size() && shown > 0 && (static_cast<unsigned char>(what[shown]) & 0xc0U) == 0x80U)
    --shown;  // do not split a UTF-8 character
  std::string line(what.substr(0, shown));
  if (shown < what.size()) line += " ...";
  for (char& c : line)
    if (c == '\n' || c == '\r') c = ' ';
  throw FileError(fmt::format("{}: line {}, column {}: {}", file, place.line, place.column, line));
}

TextPosition position_of(const FormulaText& formula, std::size_t byte) {
  LinePiece piece{0, formula.position};
  for (const auto& one : formula.pieces)
    if (one.first <= byte) piece = one;
  piece.position.column += static_cast<int>(byte - piece.first);
  return piece.position;
}

void reject_in(const std::string& file, const FormulaText& formula, std::size_t byte, std::string_view what) {
  const auto place = position_of(formula, byte);
  if (formula.size == 0) reject_at(file, place, what);
  reject_at(file, place, fmt::format("for i = {}: {}", formula.index, what));
}

std::string read_text_file(const std::filesystem::path& file, std::size_t most_bytes) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("{}: cannot be read: {}", file.string(), why));
  };
  std::error_code problem;
  const auto kind = std::filesystem::status(file, problem);
  if (!std::filesystem::exists(kind)) refuse("there is no such file");
  if (!std::filesystem::is_regular_file(kind)) refuse("it is no file");
  const auto size = std::filesystem::file_size(file, problem);
  if (problem) refuse(problem.message());
  if (size > most_bytes) refuse(fmt::format("it has {} bytes: must be at most {}", size, most_bytes));
  std::string text(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(std::strerror(errno));
  stream.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

EquationText read_equation_text(const std::filesystem::path& file) {
  return parse_equation_text(file.string(), read_text_file(file, max_equation_file_bytes));
}

EquationText with_implied_terms(EquationText text, const Parameters& parameters) {
  struct Derivative {
    std::size_t unknown;
    double order;
    bool operator==(const Derivative&) const = default;
  };
  const auto names_derivative = [](const UnknownText& one) {
    return one.rhs.text.find("D(") != std::string::npos;
  };
  if (text.outputs.empty() && std::ranges::none_of(text.unknowns, names_derivative)) return text;
  FileFormulas formulas(text, parameters, NumberStorage::values);
  std::vector<Derivative> derivatives;  // number i is variable i + 1
  const FormulaVariables variables{.time = true,
                                   .resolve_unknown =
                                       [&](std::size_t unknown, double order) {
                                         const Derivative one{unknown, order};
                                         const auto known = std::ranges::find(derivatives, one);
                                         const auto number = static_cast<int>(known - derivatives.begin());
                                         if (known == derivatives.end()) derivatives.push_back(one);
                                         return formulas.pool().variable(number + 1);
                                       },
                                   .earlier = [](Expression of, double /*lag*/) { return of; }};
  std::vector<Expression> sides;
  for (const auto& unknown : text.unknowns) sides.push_back(formulas.read(unknown.rhs, variables));
  for (const auto& output : text.outputs)
    sides.push_back(formulas.read({.text = output.name, .position = {}}, variables));
  EquationText complete = text;
  const auto used = formulas.pool().subexpressions(sides);
  for (std::size_t i = 0; i < derivatives.size(); ++i) {
    const auto& [number, order] = derivatives[i];
    const auto variable = static_cast<std::size_t>(formulas.pool().variable(static_cast<int>(i) + 1));
    const bool is_there = variable < used.size() && used[variable];
    if (!is_there || !is_implied(orders_of(text.unknowns[number], formulas), order)) continue;
    auto& unknown = complete.unknowns[number];
    const auto position = unknown.rhs.position;
    unknown.terms.push_back(
        {{.text = "1", .position = position}, {.text = fmt::format("{}", order), .position = position}});
    unknown.rhs.text += fmt::format(" + D({}, {})", unknown.name, order);
  }
  return complete;
}

}  // namespace fde::bench
