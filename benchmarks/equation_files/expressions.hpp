#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace fde {

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

// What a formula may call: sin(x), atan2(y, x), mittag_leffler(alpha, beta, z).
struct KnownFunction {
  std::string_view name;
  Operation operation;
  std::size_t arguments;
};
std::span<const KnownFunction> known_functions();

// One of the Expressions. What an expression is made of stands before it.
using Expression = int;

// How numbers are kept: as values, operations on which are carried out in long double, or as the decimals
// that were written, for evaluation to any number of digits.
enum class Numbers { folded, written };

// Expressions of numbers and variables. What is made twice is one expression, so that a program evaluates it
// once, and all that is made of a formula is a few times its length. Sums with 0 and products with 0 and 1
// are not made.
class Expressions {
 public:
  explicit Expressions(Numbers numbers) : numbers_(numbers) {}

  struct Entry {
    Operation operation;
    std::array<Expression, 3> of{none, none, none};
    long double value = 0.0L;  // of a number
    std::string text{};        // of a number that is kept as it was written
    int variable = 0;
  };
  static constexpr Expression none = -1;

  // A decimal. It must be one.
  Expression number(const std::string& decimal);
  Expression number(int whole);
  Expression pi();
  Expression variable(int index);
  // Throws std::invalid_argument where there are more than most_expressions.
  Expression make(Operation operation, Expression a, Expression b = none, Expression c = none);

  // d/dx, x the variable; of abs and step, which have none at 0, 0 there. Throws std::invalid_argument where
  // x is in the argument of gamma, or in one of the first two of mittag_leffler.
  Expression derivative(Expression of, int variable);
  // With the variables from `first` on replaced by 0.
  Expression without_variables(Expression of, int first);

  [[nodiscard]] const Entry& operator[](Expression e) const { return entries_[static_cast<std::size_t>(e)]; }
  [[nodiscard]] bool depends_on(Expression of, int variable) const;
  [[nodiscard]] std::set<int> variables_in(Expression of) const;
  // Whether a variable other than t, variable 0, is in it.
  [[nodiscard]] bool depends_on_unknowns(Expression of) const;
  // What these operations are applied to in the expressions, each once, in order.
  [[nodiscard]] std::vector<Expression> arguments(const std::vector<Expression>& in,
                                                  const std::set<Operation>& operations) const;
  // The number that it is, if it is made of numbers alone.
  [[nodiscard]] std::optional<long double> value(Expression of) const;
  // For each expression up to the last of these whether one of these is made of it.
  [[nodiscard]] std::vector<bool> parts(const std::vector<Expression>& of) const;
  [[nodiscard]] std::vector<bool> parts(Expression of) const;

  static constexpr std::size_t most_expressions = 200'000;

 private:
  using Key = std::tuple<Operation, Expression, Expression, Expression>;

  Expression add(Entry entry);
  Expression folded(long double value);
  Expression whole_power(Expression base, int exponent);
  std::optional<Expression> simplified(Operation operation, Expression a, Expression b);
  Expression derivative_of(const Entry& entry, const std::vector<Expression>& derivatives);
  [[nodiscard]] bool is(Expression e, int whole) const;

  Numbers numbers_;
  std::vector<Entry> entries_{};
  std::map<Key, Expression> known_{};
  std::map<std::pair<long double, std::string>, Expression> known_numbers_{};
};

}  // namespace fde
