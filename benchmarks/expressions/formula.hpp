// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"

namespace fde::bench {

// The names in a formula, other than functions and pi.
struct FormulaNames {
  std::function<std::optional<Expression>(std::string_view name)> resolve{};
  // D(x, order), a derivative of an unknown, or of a component as "u[3]"; `is_decimal`: whether the order is
  // written as a number, as in D(x, 1). Empty: derivatives are not allowed. Throws std::invalid_argument with
  // the reason if there is no derivative of that order.
  std::function<Expression(std::string_view unknown, Expression order, bool is_decimal)> derivative{};
  // D(of, order), where `of` is a formula of t. Empty: such derivatives are not allowed. Throws
  // std::invalid_argument with the reason if there is none.
  std::function<Expression(Expression of, Expression order)> time_derivative{};
  // x(time), where `of` is the variable of an unknown or of a derivative. Empty: earlier values are not
  // allowed. Throws std::invalid_argument with the reason if there is no such value.
  std::function<Expression(Expression of, Expression time)> earlier{};
  // The component name[index] of a vector. Empty: there are no vectors. Throws std::invalid_argument with the
  // reason if there is no such vector or component.
  std::function<Expression(std::string_view name, int index)> component{};
  std::span<const std::shared_ptr<const SampledFunction>> tables{};  // functions of one argument
  // Called for each value of a table, with the place of its name.
  std::function<void(Expression value, std::size_t byte_offset)> on_sampled{};
  std::vector<std::string_view> accepted_names{};  // the names that `resolve` accepts, for messages
};

// An error in a formula and its position, in bytes from the beginning.
struct FormulaError : std::invalid_argument {
  FormulaError(const std::string& what, std::size_t at) : std::invalid_argument(what), byte_offset(at) {}
  std::size_t byte_offset;
};

inline constexpr std::size_t max_formula_bytes = 20'000;
inline constexpr int max_nesting_depth = 200;  // nesting of brackets, signs and powers

// Parses sums, products, quotients, powers (x^y^z = x^(y^z), -x^2 = -(x^2)), brackets, decimals, names and
// functions; components u[i], and sum(j, a, b, f), the sum of f for j = a, a + 1, ..., b, which is 0 where b
// < a. Throws FormulaError.
Expression read_formula(std::string_view text, const FormulaNames& names, ExpressionPool& into);

// A letter followed by letters, digits and _.
bool is_name(std::string_view text);
// Whether it is t, D or pi.
bool is_symbol(std::string_view name);
// Whether it is the name of a function. A parameter may have the same name; without a following bracket the
// name means the parameter: gamma and gamma(x).
bool is_function(std::string_view name);

}  // namespace fde::bench
