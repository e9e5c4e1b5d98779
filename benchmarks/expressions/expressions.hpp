// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace fde::bench {

enum class Operation : unsigned char {
  number,
  pi,
  variable,
  add,
  subtract,
  multiply,
  divide,
  power,
  negate,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sinh,
  cosh,
  tanh,
  exp,
  log,
  sqrt,
  abs,
  sign,  // -1, 0 at 0, 1
  step,  // 0, 1/2 at 0, 1
  gamma,
  atan2,
  min,
  max,
  mittag_leffler
};

// A function that a formula may call: sin(x), atan2(y, x), mittag_leffler(alpha, beta, z).
struct FunctionSignature {
  std::string_view name;
  Operation operation;
  std::size_t arguments;
};
std::span<const FunctionSignature> function_table();

// An expression: the index of its node in an ExpressionPool. Its subexpressions have smaller indices.
using Expression = int;

// How numbers are stored: as long double values, with constant folding; as the decimals that were written,
// for evaluation to any number of digits; or as fractions, "3" or "1/3", whose sums, products and quotients
// are fractions again.
enum class NumberStorage { values, decimals, fractions };

// Expressions of numbers and variables. Equal expressions are stored once, so that a program evaluates them
// once and their number is a small multiple of the length of the formula. Sums with 0 and products with 0 and
// 1 are simplified.
class ExpressionPool {
 public:
  explicit ExpressionPool(NumberStorage numbers) : numbers_(numbers) {}

  struct Node {
    Operation operation;
    std::array<Expression, 3> arguments{none, none, none};
    long double value = 0.0L;  // of a number
    std::string text{};        // of a number stored as written or as a fraction
    int variable = 0;
  };
  static constexpr Expression none = -1;

  // Precondition: the text is a decimal.
  Expression number(const std::string& decimal);
  Expression number(int whole);
  // The number whose nearest double this is: a constant that was added, or else its shortest decimal.
  Expression number(double nearest);
  void add_constant(double nearest, Expression exact) { constants_.try_emplace(nearest, exact); }
  Expression pi();
  Expression variable(int index);
  // Throws std::invalid_argument if there are more than most_expressions expressions.
  Expression make_expression(Operation operation, Expression a, Expression b = none, Expression c = none);

  // d/dx for x the variable; 0 for abs and step at their kink or jump. Throws std::invalid_argument if x
  // occurs in the argument of gamma or in one of the first two arguments of mittag_leffler.
  Expression derivative(Expression of, int variable);
  // The derivatives of several expressions, in which each common part is differentiated once.
  std::vector<Expression> derivatives(const std::vector<Expression>& of, int variable);
  // The expressions with each variable i replaced by value(i).
  std::vector<Expression> substituted(const std::vector<Expression>& of,
                                      const std::function<Expression(int variable)>& value);
  // The expression with the variables from index `first` on replaced by 0.
  Expression without_variables(Expression of, int first);

  [[nodiscard]] const Node& operator[](Expression e) const { return entries_[static_cast<std::size_t>(e)]; }
  [[nodiscard]] bool depends_on(Expression of, int variable) const;
  [[nodiscard]] std::set<int> variables_in(Expression of) const;
  // Whether it depends on a variable other than t, variable 0.
  [[nodiscard]] bool depends_on_unknowns(Expression of) const;
  // The arguments of these operations in the expressions, each once, in increasing order.
  [[nodiscard]] std::vector<Expression> arguments(const std::vector<Expression>& in,
                                                  const std::set<Operation>& operations) const;
  // The value, if the expression contains no variable.
  [[nodiscard]] std::optional<long double> value(Expression of) const;
  // Element e, up to the largest index in `of`: whether expression e is a subexpression of one of these.
  [[nodiscard]] std::vector<bool> subexpressions(const std::vector<Expression>& of) const;
  [[nodiscard]] std::vector<bool> subexpressions(Expression of) const;

  [[nodiscard]] bool has_fractions() const { return numbers_ == NumberStorage::fractions; }

  static constexpr std::size_t most_expressions = 200'000;

 private:
  using Key = std::tuple<Operation, Expression, Expression, Expression>;

  Expression add(Node entry);
  Expression folded(long double value, const std::string& text = "");
  std::optional<Expression> folded_fraction(Operation operation, Expression a, Expression b);
  Expression integer_power(Expression base, int exponent);
  std::optional<Expression> simplified(Operation operation, Expression a, Expression b);
  Expression derivative_of(const Node& entry, const std::vector<Expression>& derivatives);
  [[nodiscard]] bool is(Expression e, int whole) const;

  NumberStorage numbers_;
  std::vector<Node> entries_{};
  std::map<Key, Expression> known_{};
  std::map<std::pair<long double, std::string>, Expression> known_numbers_{};
  std::map<double, Expression> constants_{};
};

}  // namespace fde::bench
