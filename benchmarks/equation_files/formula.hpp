#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "equation_files/expressions.hpp"

namespace fde {

// What a formula may name beside functions and pi.
struct FormulaNames {
  std::function<std::optional<Expression>(std::string_view name)> of{};
  // D(x, order): the derivative of an unknown; empty: none may stand there. Throws std::invalid_argument with
  // the reason where there is none of that order.
  std::function<Expression(std::string_view unknown, Expression order)> derivative{};
  std::vector<std::string_view> known{};  // those that `of` takes, for messages
};

// What is wrong with a formula, and where: a number of bytes from its beginning.
struct FormulaFault : std::invalid_argument {
  FormulaFault(const std::string& what, std::size_t at) : std::invalid_argument(what), place(at) {}
  std::size_t place;
};

inline constexpr std::size_t longest_formula = 20'000;
inline constexpr int deepest_formula = 200;  // brackets, signs and powers within each other

// Reads sums, products, quotients, powers (x^y^z = x^(y^z), -x^2 = -(x^2)), brackets, decimals, names and
// functions. Throws FormulaFault.
Expression read_formula(std::string_view text, const FormulaNames& names, Expressions& into);

// Letters, digits and _, a letter first.
bool is_name(std::string_view text);
// Whether it is t, D or pi.
bool is_symbol(std::string_view name);
// Whether it names a function. A parameter may have such a name, and is meant where no bracket follows: gamma
// beside gamma(x).
bool is_function(std::string_view name);

}  // namespace fde
