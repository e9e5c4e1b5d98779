// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/expressions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <queue>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/expressions/apply.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::bench {
namespace {

constexpr int largest_whole_power = 64;  // evaluated by multiplication

constexpr std::array signatures{
    OperationSignature{"number", 0, false},
    OperationSignature{"pi", 0, false},
    OperationSignature{"variable", 0, false},
#define FDE_OPERATION(name, arguments, value) OperationSignature{#name, arguments, false},
#define FDE_FUNCTION(name, arguments, value) OperationSignature{#name, arguments, true},
#include "fdebench/benchmarks/expressions/operations.def"
};

}  // namespace

const OperationSignature& signature(Operation operation) {
  return signatures[static_cast<std::size_t>(operation)];
}

std::optional<Operation> function_named(std::string_view name) {
  const auto* const known = std::ranges::find(signatures, std::pair(name, true), [](const auto& one) {
    return std::pair(one.name, one.is_function);
  });
  if (known == signatures.end()) return std::nullopt;
  return static_cast<Operation>(known - signatures.begin());
}

std::vector<std::string_view> function_names() {
  std::vector<std::string_view> names;
  for (const auto& one : signatures)
    if (one.is_function) names.push_back(one.name);
  return names;
}

Expression ExpressionPool::add(Node entry) {
  if (entries_.size() >= most_expressions) {
    throw std::invalid_argument(
        fmt::format("its expressions have more than {} different parts", most_expressions));
  }
  entries_.push_back(std::move(entry));
  return static_cast<Expression>(entries_.size()) - 1;
}

Expression ExpressionPool::number(const std::string& decimal) {
  const char* const end = decimal.data() + decimal.size();
  long double value = 0.0L;
  double nearest = 0.0;
  std::from_chars(decimal.data(), end, value);
  std::from_chars(decimal.data(), end, nearest);
  if (static_cast<double>(value) != nearest)
    value = nearest;  // avoids double rounding, which could give a neighbour of the nearest double
  if (numbers_ == NumberStorage::values || !std::isfinite(value)) return folded(value);
  return folded(value, has_fractions() ? reference::decimal_fraction(decimal).str() : decimal);
}

Expression ExpressionPool::number(int whole) { return number(std::to_string(whole)); }

Expression ExpressionPool::number(double nearest) {
  const auto known = constants_.find(nearest);
  return known == constants_.end() ? number(fmt::format("{}", nearest)) : known->second;
}

Expression ExpressionPool::folded(long double value, const std::string& text) {
  const std::pair<long double, std::string> key{value, text};
  const auto found = known_numbers_.find(key);
  if (found != known_numbers_.end()) return found->second;
  return known_numbers_[key] = add({.operation = Operation::number, .value = value, .text = text});
}

// nullopt for an operation that is not rational, a division by 0, and a fraction that is too long.
std::optional<Expression> ExpressionPool::folded_fraction(Operation operation, Expression a, Expression b) {
  constexpr std::size_t longest = 2000;
  using reference::Rational;
  if ((*this)[a].text.empty() || (b != none && (*this)[b].text.empty())) return std::nullopt;  // not finite
  const Rational x((*this)[a].text), y(b == none ? "0" : (*this)[b].text);
  const auto of = [&](const Rational& value) -> std::optional<Expression> {
    const std::string text = value.str();
    if (text.size() > longest) return std::nullopt;
    return folded(reference::rounded<long double>(value), text);
  };
  switch (operation) {
    case Operation::add:
      return of(x + y);
    case Operation::subtract:
      return of(x - y);
    case Operation::multiply:
      return of(x * y);
    case Operation::divide:
      return y == 0 ? std::nullopt : of(x / y);
    case Operation::negate:
      return of(-x);
    case Operation::abs:
      return of(x < 0 ? Rational(-x) : x);
    case Operation::floor:
      return of(reference::floor(x));
    case Operation::sign:
      return of(Rational(x.sign()));
    case Operation::step:
      return of(Rational(x.sign() + 1, 2));
    case Operation::min:
      return of(y < x ? y : x);
    case Operation::max:
      return of(x < y ? y : x);
    default:
      return std::nullopt;
  }
}

Expression ExpressionPool::pi() {
  return numbers_ == NumberStorage::values ? folded(std::numbers::pi_v<long double>)
                                           : make_expression(Operation::pi, none, none, none);
}

Expression ExpressionPool::variable(int index) {
  const auto [place, is_new] = known_.try_emplace(Key{Operation::variable, index, none, none, nullptr}, none);
  if (is_new) place->second = add({.operation = Operation::variable, .variable = index});
  return place->second;
}

bool ExpressionPool::is(Expression e, int whole) const {
  return e != none && (*this)[e].operation == Operation::number &&
         (*this)[e].value == static_cast<long double>(whole);
}

// (t + c) + d or (t + c) - d with numbers c and d as t + (c + d), and as t where c and d cancel; decimals may
// be written in several ways. nullopt for another sum.
std::optional<Expression> ExpressionPool::moved_time(Operation operation, Expression a, Expression b) {
  const auto [t, c, none_left] = (*this)[a].arguments;
  const auto is_number = [&](Expression e) { return (*this)[e].operation == Operation::number; };
  if ((*this)[a].operation != Operation::add || t != variable(0) || !is_number(c) || !is_number(b))
    return std::nullopt;
  const bool same = (*this)[c].value == (*this)[b].value && (!has_fractions() || c == b);
  if (same && operation == Operation::subtract) return t;
  return make_expression(Operation::add, t, make_expression(operation, c, b));
}

// By repeated squaring.
Expression ExpressionPool::integer_power(Expression base, int exponent) {
  if (exponent < 0) return make_expression(Operation::divide, number(1), integer_power(base, -exponent));
  if (exponent == 0) return number(1);
  if (exponent == 1) return base;
  const auto half = integer_power(base, exponent / 2);
  const auto square = make_expression(Operation::multiply, half, half);
  return exponent % 2 == 0 ? square : make_expression(Operation::multiply, square, base);
}

// The simplified form of an operation with 0 or 1, a double negation, (t + c) - d, an integer power, or ceil
// and mod, which are made of floor; nullopt: none.
std::optional<Expression> ExpressionPool::simplified(Operation operation, Expression a, Expression b) {
  switch (operation) {
    case Operation::add:
      if (is(a, 0)) return b;
      if (is(b, 0)) return a;
      return moved_time(operation, a, b);
    case Operation::subtract:
      if (is(b, 0)) return a;
      if (is(a, 0)) return make_expression(Operation::negate, b);
      return moved_time(operation, a, b);
    case Operation::multiply:
      if (is(a, 0) || is(b, 1)) return a;
      if (is(b, 0) || is(a, 1)) return b;
      break;
    case Operation::divide:
      if (is(b, 1)) return a;
      break;
    case Operation::negate:
      if (is(a, 0)) return a;
      if ((*this)[a].operation == Operation::negate) return (*this)[a].arguments[0];
      break;
    case Operation::power:
      if ((*this)[b].operation == Operation::number && (*this)[b].value == std::rint((*this)[b].value) &&
          std::abs((*this)[b].value) <= largest_whole_power)
        return integer_power(a, static_cast<int>((*this)[b].value));
      break;
    case Operation::ceil:
      return (-floor(-Operand{this, a})).value;
    case Operation::mod: {
      const Operand x{this, a}, period{this, b};
      return (x - period * floor(x / period)).value;
    }
    default:
      break;
  }
  return std::nullopt;
}

Expression ExpressionPool::make_expression(Operation operation, Expression a, Expression b, Expression c) {
  const std::array of{a, b, c};
  bool numbers = numbers_ != NumberStorage::decimals && a != none;
  std::array<long double, 3> values{};
  for (std::size_t i = 0; i < of.size() && of[i] != none; ++i) {
    numbers = numbers && (*this)[of[i]].operation == Operation::number;
    if (numbers) values[i] = (*this)[of[i]].value;
  }
  if (numbers && has_fractions()) {
    if (const auto fraction = folded_fraction(operation, a, b)) return *fraction;
  } else if (numbers) {
    const long double value = apply(operation, values[0], values[1], values[2]);
    if (std::isfinite(value)) return folded(value);
  }
  if (a != none) {
    if (const auto known = simplified(operation, a, b)) return *known;
  }
  return kept({.operation = operation, .arguments = of});
}

// The expression of this node, which may be there already.
Expression ExpressionPool::kept(Node entry) {
  const auto [a, b, c] = entry.arguments;
  const Key key{entry.operation, a, b, c, entry.function.get()};
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  return known_[key] = add(std::move(entry));
}

Expression ExpressionPool::sampled(const std::shared_ptr<const SampledFunction>& function,
                                   Expression argument) {
  if (numbers_ == NumberStorage::values && (*this)[argument].operation == Operation::number) {
    if (const long double value = function->at((*this)[argument].value); std::isfinite(value))
      return folded(value);
  }
  return kept({.operation = Operation::sampled, .arguments = {argument, none, none}, .function = function});
}

Expression ExpressionPool::with_arguments(const Node& node, Expression a, Expression b, Expression c) {
  return node.function ? sampled(node.function, a) : make_expression(node.operation, a, b, c);
}

std::vector<bool> ExpressionPool::subexpressions(const std::vector<Expression>& of) const {
  const Expression last = of.empty() ? none : std::ranges::max(of);
  std::vector<bool> used(static_cast<std::size_t>(last + 1), false);
  for (const auto e : of) used[static_cast<std::size_t>(e)] = true;
  for (Expression e = last; e >= 0; --e) {
    if (!used[static_cast<std::size_t>(e)]) continue;
    for (const auto part : (*this)[e].arguments)
      if (part != none) used[static_cast<std::size_t>(part)] = true;
  }
  return used;
}

std::vector<bool> ExpressionPool::subexpressions(Expression of) const {
  return subexpressions(std::vector{of});
}

// The largest first: arguments have smaller indices.
std::vector<Expression> ExpressionPool::parts(const std::vector<Expression>& of) const {
  std::priority_queue<Expression> open(of.begin(), of.end());
  std::vector<Expression> found;
  while (!open.empty()) {
    const Expression e = open.top();
    open.pop();
    if (!found.empty() && found.back() == e) continue;
    found.push_back(e);
    for (const auto part : (*this)[e].arguments)
      if (part != none) open.push(part);
  }
  std::ranges::reverse(found);
  return found;
}

bool ExpressionPool::depends_on(Expression of, int variable) const {
  const auto found = known_.find(Key{Operation::variable, variable, none, none, nullptr});
  return found != known_.end() && found->second <= of &&
         std::ranges::binary_search(parts({of}), found->second);
}

std::set<int> ExpressionPool::variables_in(Expression of) const {
  std::set<int> found;
  for (const auto e : parts({of}))
    if ((*this)[e].operation == Operation::variable) found.insert((*this)[e].variable);
  return found;
}

bool ExpressionPool::depends_on_unknowns(Expression of) const {
  const auto variables = variables_in(of);
  return variables.upper_bound(0) != variables.end();
}

std::vector<Expression> ExpressionPool::arguments(const std::vector<Expression>& in,
                                                  const std::function<bool(const Node& node)>& is_one) const {
  const auto used = subexpressions(in);
  std::set<Expression> found;
  for (std::size_t e = 0; e < used.size(); ++e) {
    const auto& part = (*this)[static_cast<Expression>(e)];
    if (!used[e] || !is_one(part)) continue;
    for (const auto argument : part.arguments)
      if (argument != none) found.insert(argument);
  }
  return {found.begin(), found.end()};
}

std::vector<Expression> ExpressionPool::switches(const std::vector<Expression>& in,
                                                 const std::function<bool(const Node& node)>& is_one) {
  const auto used = subexpressions(in);
  std::set<Expression> found;
  for (std::size_t e = 0; e < used.size(); ++e) {
    const auto& part = (*this)[static_cast<Expression>(e)];
    if (!used[e] || !is_one(part)) continue;
    const Expression argument = part.arguments[0];
    found.insert(part.function                        ? sampled(part.function->alternation(), argument)
                 : part.operation == Operation::floor ? make_expression(Operation::alternation, argument)
                                                      : argument);
  }
  return {found.begin(), found.end()};
}

std::optional<long double> ExpressionPool::value(Expression of) const {
  if ((*this)[of].operation == Operation::number) return (*this)[of].value;
  if (!variables_in(of).empty()) return std::nullopt;
  return values_from_parts(*this, {of}, 0.0L,
                           [](Expression, const Node& node, const auto& parts) {
                             return node.operation == Operation::number
                                        ? node.value
                                        : apply(node, parts(0), parts(1), parts(2));
                           })
      .front();
}

std::vector<Expression> ExpressionPool::substituted(const std::vector<Expression>& of,
                                                    const std::function<Expression(int variable)>& value) {
  return values_from_parts(*this, of, none, [&](Expression e, const Node& node, const auto& parts) {
    if (node.operation == Operation::variable) return value(node.variable);
    return parts(0) == none ? e : with_arguments(node, parts(0), parts(1), parts(2));
  });
}

Expression ExpressionPool::without_variables(Expression of, int first) {
  return substituted({of}, [&](int i) { return i >= first ? number(0) : variable(i); }).front();
}

bool jumps(const ExpressionPool::Node& node) {
  return node.operation == Operation::sign || node.operation == Operation::step ||
         node.operation == Operation::floor || (node.function && node.function->jumping_derivative() == 0);
}

bool has_kink(const ExpressionPool::Node& node) {
  return node.operation == Operation::abs || node.operation == Operation::min ||
         node.operation == Operation::max || (node.function && node.function->jumping_derivative() == 1);
}

}  // namespace fde::bench
