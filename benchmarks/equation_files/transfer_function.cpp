// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/transfer_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/file_formulas.hpp"
#include "fdebench/benchmarks/equation_files/states.hpp"
#include "fdebench/benchmarks/expressions/formula_text.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {
namespace {

using reference::Rational;

constexpr int s_variable = 1;
constexpr std::size_t most_powers_of_s = 100;

// A sum of powers of s: the coefficients by order.
using PowerSum = std::map<Rational, Operand>;
struct Quotient {
  PowerSum numerator{}, denominator{};
};

[[noreturn]] void refuse(std::string_view why) {
  throw std::invalid_argument(fmt::format("transfer: {}", why));
}

// Evaluates a formula of s as a quotient of sums of powers.
class TransferFormula {
 public:
  explicit TransferFormula(ExpressionPool& pool) : pool_(pool) {}

  Quotient quotient(Expression of) {
    const auto value_of = [&](Expression e, const ExpressionPool::Node& node, const auto& parts) {
      if (!pool_.depends_on(e, s_variable)) return Quotient{{{0, {&pool_, e}}}, one()};
      if (node.operation == Operation::variable) return Quotient{{{1, number(1)}}, one()};
      return combined(node, parts);
    };
    return values_from_parts<Quotient>(pool_, {of}, Quotient{}, value_of).front();
  }

 private:
  Operand number(int value) { return {&pool_, pool_.number(value)}; }
  PowerSum one() { return {{0, number(1)}}; }

  template <class Parts>
  Quotient combined(const ExpressionPool::Node& node, const Parts& parts) {
    const Quotient &a = parts(0), &b = parts(1);
    switch (node.operation) {
      case Operation::negate:
        return {product(a.numerator, {{0, number(-1)}}), a.denominator};
      case Operation::add:
        return sum(a, b);
      case Operation::subtract:
        return sum(a, {product(b.numerator, {{0, number(-1)}}), b.denominator});
      case Operation::multiply:
        return {product(a.numerator, b.numerator), product(a.denominator, b.denominator)};
      case Operation::divide:
        return {product(a.numerator, b.denominator), product(a.denominator, b.numerator)};
      case Operation::power:
        return power(a, node.arguments[1]);
      case Operation::sqrt:
        return power(a, (number(1) / number(2)).value);
      default:
        refuse("must be a quotient of sums of powers of s");
    }
  }

  PowerSum product(const PowerSum& a, const PowerSum& b) {
    PowerSum result;
    for (const auto& [p, x] : a)
      for (const auto& [q, y] : b) add(Rational(p + q), x * y, result);
    return result;
  }

  Quotient sum(const Quotient& a, const Quotient& b) {
    PowerSum numerator = product(a.numerator, b.denominator);
    for (const auto& [p, x] : product(b.numerator, a.denominator)) add(p, x, numerator);
    return {numerator, product(a.denominator, b.denominator)};
  }

  void add(const Rational& order, Operand coefficient, PowerSum& to) {
    const auto [known, is_new] = to.try_emplace(order, coefficient);
    if (!is_new) known->second = known->second + coefficient;
    if (pool_.value(known->second.value) == 0.0L) to.erase(known);
    if (to.size() > most_powers_of_s) refuse(fmt::format("has more than {} powers of s", most_powers_of_s));
  }

  Quotient power(const Quotient& base, Expression exponent) {
    const auto value = pool_.value(exponent);
    if (!value || std::abs(*value) > 100.0L)
      refuse("an exponent must be a number of at most 100, or a formula of the parameters");
    if (*value != std::floor(*value)) {
      return {power_of_one_term(base.numerator, exponent), power_of_one_term(base.denominator, exponent)};
    }
    Quotient result{one(), one()};
    for (int k = 0; k < static_cast<int>(std::abs(*value)); ++k)
      result = {product(result.numerator, base.numerator), product(result.denominator, base.denominator)};
    return *value < 0.0L ? Quotient{result.denominator, result.numerator} : result;
  }

  PowerSum power_of_one_term(const PowerSum& base, Expression exponent) {
    if (base.size() != 1) refuse("a power of a sum must have a whole exponent");
    const auto& [order, coefficient] = *base.begin();
    const bool is_one = coefficient.value == pool_.number(1);
    return {{Rational(order * nearest_fraction(exponent, pool_)),
             is_one ? coefficient : pow(coefficient, {&pool_, exponent})}};
  }

  ExpressionPool& pool_;
};

Quotient transfer_function(const FormulaText& transfer, FileFormulas& formulas) {
  const auto is_s = [](const ParameterText& one) { return one.declared.name == "s"; };
  if (std::ranges::any_of(formulas.text().parameters, is_s))
    formulas.reject(transfer, "parameter s: must be another name, s is the variable of transfer functions");
  auto& pool = formulas.pool();
  const auto s = [&](std::string_view name) -> std::optional<Expression> {
    return name == "s" ? std::optional(pool.variable(s_variable)) : std::nullopt;
  };
  const auto written = formulas.read(transfer, {.time = false, .resolve_other = s, .other_names = {"s"}});
  try {
    return TransferFormula(pool).quotient(written);
  } catch (const std::invalid_argument& fault) {
    formulas.reject(transfer, fault.what());
  }
}

// The terms of a sum of powers over s^lowest and a number.
std::vector<TermText> terms_of(const PowerSum& sum, const Rational& lowest, Operand divisor,
                               const TextPosition& place) {
  std::vector<TermText> terms;
  const auto formula = [&](std::string text) {
    return FormulaText{.text = std::move(text), .position = place};
  };
  for (const auto& [order, coefficient] : sum) {
    const auto value = (coefficient / divisor).value;
    terms.push_back(
        {formula(formula_text(*divisor.pool, value, {})), formula(Rational(order - lowest).str())});
  }
  std::ranges::reverse(terms);
  return terms;
}

// Makes the unknown the state; returns what its name stands for.
OutputText make_state(UnknownText& unknown, FileFormulas& formulas) {
  const auto& transfer = *unknown.transfer;
  const auto [numerator, denominator] = transfer_function(transfer, formulas);
  if (denominator.empty()) formulas.reject(transfer, "transfer: is divided by 0");
  if (numerator.empty()) formulas.reject(transfer, "transfer: is 0: must be another function");
  const Rational lowest = std::min(numerator.begin()->first, denominator.begin()->first);
  const Rational top = denominator.rbegin()->first - lowest, below = numerator.rbegin()->first - lowest;
  if (below >= top) {
    formulas.reject(transfer,
                    fmt::format("transfer: its highest order below the line, {}, must be above that "
                                "over it, {}",
                                static_cast<double>(top), static_cast<double>(below)));
  }
  const Operand one{&formulas.pool(), formulas.pool().number(1)};
  const auto divisor = numerator.size() == 1 ? numerator.begin()->second : one;
  unknown.terms = terms_of(denominator, lowest, divisor, transfer.position);
  const FormulaText zero{.text = "0", .position = transfer.position};
  unknown.initial.assign(initial_count(static_cast<double>(top)), zero);
  unknown.before = zero;
  unknown.is_implied = true;
  unknown.meaning = state_meaning(unknown.name);
  OutputText output{.name = unknown.name,
                    .state = free_name(unknown.name + "_state", formulas.text().contents),
                    .terms = terms_of(numerator, lowest, divisor, transfer.position)};
  unknown.name = output.state;
  return output;
}

}  // namespace

EquationText with_states(EquationText text, const Parameters& parameters) {
  const auto has_transfer = [](const UnknownText& one) { return one.transfer.has_value(); };
  if (std::ranges::none_of(text.unknowns, has_transfer)) return text;
  const EquationText given = text;
  FileFormulas formulas(given, parameters, NumberStorage::fractions);
  for (auto& unknown : text.unknowns)
    if (unknown.transfer) text.outputs.push_back(make_state(unknown, formulas));
  return text;
}

}  // namespace fde::bench
