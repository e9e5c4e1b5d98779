// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace fde::bench {

class SampledFunction;

enum class Operation : unsigned char {
  number,
  pi,
  variable,
#define FDE_OPERATION(name, arguments, value) name,
#include "fdebench/benchmarks/expressions/operations.def"
};

// What is known of an operation; a function is called by its name in formulas: sin(x), atan2(y, x),
// mittag_leffler(alpha, beta, z).
struct OperationSignature {
  std::string_view name;
  std::size_t arguments;
  bool is_function;
};
const OperationSignature& signature(Operation operation);

// The functions by name; nullopt for another name.
std::optional<Operation> function_named(std::string_view name);
std::vector<std::string_view> function_names();

// An expression: the index of its node in an ExpressionPool. Its subexpressions have smaller indices.
using Expression = int;

// How numbers are stored: as long double values, with constant folding; as the decimals that were written,
// for evaluation to any number of digits; or as fractions, "3" or "1/3", whose sums, products and quotients
// are fractions again.
enum class NumberStorage { values, decimals, fractions };

// Expressions of numbers and variables. Equal expressions are stored once, so that a program evaluates them
// once and their number is a small multiple of the length of the formula. Sums with 0, products with 0 and 1
// and (t + c) - d with numbers c and d are simplified.
class ExpressionPool {
 public:
  explicit ExpressionPool(NumberStorage numbers) : numbers_(numbers) {}

  struct Node {
    Operation operation;
    std::array<Expression, 3> arguments{none, none, none};
    long double value = 0.0L;  // of a number
    std::string text{};        // of a number stored as written or as a fraction
    int variable = 0;
    std::shared_ptr<const SampledFunction> function{};  // of a table
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
  // The function of a table at an argument.
  Expression sampled(const std::shared_ptr<const SampledFunction>& function, Expression argument);
  // The operation of a node with other arguments.
  Expression with_arguments(const Node& node, Expression a, Expression b = none, Expression c = none);

  // d/dx for x the variable; 0 for abs, step and floor at their kink or jump. Throws std::invalid_argument if
  // x occurs in the argument of gamma or in one of the first two arguments of mittag_leffler.
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
  // The arguments of the operations in the expressions of which this is true, each once, in increasing order.
  [[nodiscard]] std::vector<Expression> arguments(const std::vector<Expression>& in,
                                                  const std::function<bool(const Node& node)>& is_one) const;
  // Expressions at whose changes of sign the given ones jump by an operation of which `is_one` is true: the
  // arguments of sign and step, and the alternation of the argument of floor, or of a table, in increasing
  // order. Precondition: jumps() is true of each such operation.
  std::vector<Expression> switches(const std::vector<Expression>& in,
                                   const std::function<bool(const Node& node)>& is_one);
  // The value, if the expression contains no variable.
  [[nodiscard]] std::optional<long double> value(Expression of) const;
  // Element e, up to the largest index in `of`: whether expression e is a subexpression of one of these.
  [[nodiscard]] std::vector<bool> subexpressions(const std::vector<Expression>& of) const;
  [[nodiscard]] std::vector<bool> subexpressions(Expression of) const;
  // These subexpressions in increasing order, in a time that depends on their number alone and not on that of
  // all expressions: so is the time for all rows of a field.
  [[nodiscard]] std::vector<Expression> parts(const std::vector<Expression>& of) const;

  [[nodiscard]] bool has_fractions() const { return numbers_ == NumberStorage::fractions; }

  static constexpr std::size_t most_expressions = 200'000;

 private:
  using Key = std::tuple<Operation, Expression, Expression, Expression, const SampledFunction*>;

  Expression add(Node entry);
  Expression kept(Node entry);
  Expression folded(long double value, const std::string& text = "");
  std::optional<Expression> folded_fraction(Operation operation, Expression a, Expression b);
  Expression integer_power(Expression base, int exponent);
  std::optional<Expression> simplified(Operation operation, Expression a, Expression b);
  Expression derivative_of(Expression self, const Node& node,
                           const std::function<Expression(std::size_t i)>& derivatives);
  [[nodiscard]] bool is(Expression e, int whole) const;
  std::optional<Expression> moved_time(Operation operation, Expression a, Expression b);

  NumberStorage numbers_;
  std::deque<Node> entries_{};  // of which none moves: a reference to one is kept while others are added
  std::map<Key, Expression> known_{};
  std::map<std::pair<long double, std::string>, Expression> known_numbers_{};
  std::map<double, Expression> constants_{};
};

// Whether an operation jumps for some argument: sign, step, floor and tables between whose samples it is
// constant.
bool jumps(const ExpressionPool::Node& node);
// Whether it has a kink: abs, min, max and tables between whose samples it is linear.
bool has_kink(const ExpressionPool::Node& node);

// An expression and its pool, for formulas that are written with operators and functions.
struct Operand {
  ExpressionPool* pool;
  Expression value;

  [[nodiscard]] Operand of(Operation operation, Expression b = ExpressionPool::none,
                           Expression c = ExpressionPool::none) const {
    return {pool, pool->make_expression(operation, value, b, c)};
  }
  friend Operand operator+(Operand a, Operand b) { return a.of(Operation::add, b.value); }
  friend Operand operator-(Operand a, Operand b) { return a.of(Operation::subtract, b.value); }
  friend Operand operator*(Operand a, Operand b) { return a.of(Operation::multiply, b.value); }
  friend Operand operator/(Operand a, Operand b) { return a.of(Operation::divide, b.value); }
  friend Operand operator-(Operand a) { return a.of(Operation::negate); }
  friend Operand operator+(int a, Operand b) { return Operand{b.pool, b.pool->number(a)} + b; }
  friend Operand operator-(int a, Operand b) { return Operand{b.pool, b.pool->number(a)} - b; }
  friend Operand operator/(int a, Operand b) { return Operand{b.pool, b.pool->number(a)} / b; }
  friend Operand operator+(Operand a, int b) { return a + Operand{a.pool, a.pool->number(b)}; }
  friend Operand operator-(Operand a, int b) { return a - Operand{a.pool, a.pool->number(b)}; }
  friend Operand pow(Operand a, Operand b) { return a.of(Operation::power, b.value); }
#define FDE_SLOPE(name, value, slope) \
  friend Operand name(Operand a) { return a.of(Operation::name); }
#include "fdebench/benchmarks/expressions/operations.def"
};

// The values of expressions, each computed once by value_of(expression, node, parts) from those of its
// arguments: parts(i), `absent` where it has no such argument. value_of may add expressions to the pool.
template <class Value, class ValueOf>
std::vector<Value> values_from_parts(const ExpressionPool& pool, const std::vector<Expression>& of,
                                     const Value& absent, const ValueOf& value_of) {
  const auto all = pool.parts(of);
  std::vector<Value> values(all.size(), absent);
  const auto value = [&](Expression e) -> Value& {
    return values[static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), e) - all.begin())];
  };
  for (std::size_t k = 0; k < all.size(); ++k) {
    const ExpressionPool::Node& node = pool[all[k]];
    const auto parts = [&](std::size_t i) -> const Value& {
      return node.arguments[i] == ExpressionPool::none ? absent : value(node.arguments[i]);
    };
    values[k] = value_of(all[k], node, parts);
  }
  std::vector<Value> results;
  results.reserve(of.size());
  for (const auto e : of) results.push_back(value(e));
  return results;
}

}  // namespace fde::bench
