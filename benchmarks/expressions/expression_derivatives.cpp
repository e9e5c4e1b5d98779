// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"

namespace fde::bench {

// Chain rule; derivatives(i) is that of argument i.
Expression ExpressionPool::derivative_of(Expression self, const Node& node,
                                         const std::function<Expression(std::size_t i)>& derivatives) {
  const auto operand = [&](Expression e) { return Operand{this, e}; };
  const auto of = [&](std::size_t i) { return node.arguments[i] == none ? number(0) : derivatives(i); };
  const Operand a = operand(node.arguments[0]), b = operand(node.arguments[1]),
                c = operand(node.arguments[2]);
  const Operand da = operand(of(0)), db = operand(of(1)), dc = operand(of(2)), f = operand(self);
  const Operand zero = operand(number(0));
  const auto half = [&] { return operand(number("0.5")); };
  const bool is_first_alone = is(db.value, 0) && is(dc.value, 0);
  switch (node.operation) {
    case Operation::add:
      return (da + db).value;
    case Operation::subtract:
      return (da - db).value;
    case Operation::multiply:
      return (da * b + a * db).value;
    case Operation::divide:
      return (is_first_alone ? da / b : (da - f * db) / b).value;
    case Operation::power:
      return (is_first_alone ? b * pow(a, b - 1) * da : f * (db * log(a) + b * da / a)).value;
    case Operation::atan2:
      return ((da * b - a * db) / (a * a + b * b)).value;
    case Operation::min:
      return (da * step(b - a) + db * step(a - b)).value;
    case Operation::max:
      return (da * step(a - b) + db * step(b - a)).value;
    case Operation::negate:
      return (operand(number(-1)) * da).value;
    case Operation::alternation:
      return (sign(cos(operand(pi()) * a)) * da).value;
    case Operation::gamma:
      throw std::invalid_argument("gamma: its argument must be without unknowns");
    case Operation::mittag_leffler: {
      // E'_(a,b) = (E_(a,a+b-1) - (b-1) E_(a,a+b)) / a, from k = ((ak + b - 1) - (b - 1)) / a in its series
      if (!is(da.value, 0) || !is(db.value, 0))
        throw std::invalid_argument("mittag_leffler: its first two arguments must be without unknowns");
      const auto at = [&](Operand beta) { return a.of(Operation::mittag_leffler, beta.value, c.value); };
      const Operand higher = a + b;
      return ((at(higher - 1) - (b - 1) * at(higher)) / a * dc).value;
    }
    case Operation::sampled: {
      const auto& slope = node.function->derivative();
      return slope ? (operand(sampled(slope, a.value)) * da).value : zero.value;
    }
#define FDE_SLOPE(name, of_a, slope) \
  case Operation::name:              \
    return ((slope)*da).value;
#include "fdebench/benchmarks/expressions/operations.def"
    default:
      return zero.value;
  }
}

std::vector<Expression> ExpressionPool::derivatives(const std::vector<Expression>& of, int variable) {
  const auto zero = number(0), one = number(1);
  return values_from_parts(*this, of, none, [&](Expression e, const Node& node, const auto& parts) {
    if (node.operation == Operation::variable) return node.variable == variable ? one : zero;
    for (std::size_t i = 0; i < node.arguments.size(); ++i)
      if (parts(i) != none && parts(i) != zero) return derivative_of(e, node, parts);
    return zero;
  });
}

Expression ExpressionPool::derivative(Expression of, int variable) {
  return derivatives({of}, variable).front();
}

}  // namespace fde::bench
