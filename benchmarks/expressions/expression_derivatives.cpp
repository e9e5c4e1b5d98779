// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include "fdebench/benchmarks/expressions/expressions.hpp"

namespace fde::bench {
namespace {

// f'(a) for a differentiable function of one argument, with f = f(a); nullopt otherwise.
std::optional<Expression> slope(ExpressionPool& pool, Operation operation, Expression a, Expression f) {
  const auto make = [&](Operation how, Expression x, Expression y = ExpressionPool::none) {
    return pool.make_expression(how, x, y);
  };
  const auto square = [&](Expression x) { return make(Operation::multiply, x, x); };
  const auto one_minus = [&](Expression x) { return make(Operation::subtract, pool.number(1), x); };
  const auto one_over = [&](Expression x) { return make(Operation::divide, pool.number(1), x); };
  switch (operation) {
    case Operation::negate:
      return pool.number(-1);
    case Operation::sin:
      return make(Operation::cos, a);
    case Operation::cos:
      return make(Operation::negate, make(Operation::sin, a));
    case Operation::tan:
      return make(Operation::add, pool.number(1), square(f));
    case Operation::asin:
      return one_over(make(Operation::sqrt, one_minus(square(a))));
    case Operation::acos:
      return make(Operation::negate, one_over(make(Operation::sqrt, one_minus(square(a)))));
    case Operation::atan:
      return one_over(make(Operation::add, pool.number(1), square(a)));
    case Operation::sinh:
      return make(Operation::cosh, a);
    case Operation::cosh:
      return make(Operation::sinh, a);
    case Operation::tanh:
      return one_minus(square(f));
    case Operation::exp:
      return f;
    case Operation::log:
      return one_over(a);
    case Operation::sqrt:
      return make(Operation::divide, pool.number("0.5"), f);
    case Operation::abs:
      return make(Operation::sign, a);
    case Operation::sign:
    case Operation::step:
      return pool.number(0);
    default:
      return std::nullopt;
  }
}

}  // namespace

// Chain rule; `derivatives` are those of the parts of the entry.
Expression ExpressionPool::derivative_of(const Node& entry, const std::vector<Expression>& derivatives) {
  const auto [a, b, c] = entry.arguments;
  const auto of = [&](Expression e) {
    return e == none ? number(0) : derivatives[static_cast<std::size_t>(e)];
  };
  const Expression da = of(a), db = of(b), dc = of(c);
  if (is(da, 0) && is(db, 0) && is(dc, 0)) return number(0);
  const Expression self = make_expression(entry.operation, a, b, c);
  const auto times = [&](Expression x, Expression y) { return make_expression(Operation::multiply, x, y); };
  const auto plus = [&](Expression x, Expression y) { return make_expression(Operation::add, x, y); };
  const auto minus = [&](Expression x, Expression y) { return make_expression(Operation::subtract, x, y); };
  const auto over = [&](Expression x, Expression y) { return make_expression(Operation::divide, x, y); };
  switch (entry.operation) {
    case Operation::add:
      return plus(da, db);
    case Operation::subtract:
      return minus(da, db);
    case Operation::multiply:
      return plus(times(da, b), times(a, db));
    case Operation::divide:
      return is(db, 0) ? over(da, b) : over(minus(da, times(self, db)), b);
    case Operation::power:
      if (is(db, 0)) return times(times(b, make_expression(Operation::power, a, minus(b, number(1)))), da);
      return times(self, plus(times(db, make_expression(Operation::log, a)), over(times(b, da), a)));
    case Operation::atan2:
      return over(minus(times(da, b), times(a, db)), plus(times(a, a), times(b, b)));
    case Operation::min:
      return plus(times(da, make_expression(Operation::step, minus(b, a))),
                  times(db, make_expression(Operation::step, minus(a, b))));
    case Operation::max:
      return plus(times(da, make_expression(Operation::step, minus(a, b))),
                  times(db, make_expression(Operation::step, minus(b, a))));
    case Operation::mittag_leffler:
      // E'_(a,b) = (E_(a,a+b-1) - (b-1) E_(a,a+b)) / a, from k = ((ak + b - 1) - (b - 1)) / a in its series
      if (is(da, 0) && is(db, 0)) {
        const auto higher = plus(a, b), lowered = minus(b, number(1));
        const auto first = make_expression(Operation::mittag_leffler, a, minus(higher, number(1)), c);
        const auto second = times(lowered, make_expression(Operation::mittag_leffler, a, higher, c));
        return times(over(minus(first, second), a), dc);
      }
      throw std::invalid_argument("mittag_leffler: its first two arguments must be without unknowns");
    default:
      break;
  }
  const auto known = slope(*this, entry.operation, a, self);
  if (!known) throw std::invalid_argument("gamma: its argument must be without unknowns");
  return times(*known, da);
}

std::vector<Expression> ExpressionPool::derivatives(const std::vector<Expression>& of, int variable) {
  const auto used = subexpressions(of);
  const auto zero = number(0), one = number(1);
  std::vector<Expression> made(used.size(), none);
  const auto is_constant = [&](Expression e) {
    return e == none || made[static_cast<std::size_t>(e)] == zero;
  };
  for (std::size_t e = 0; e < used.size(); ++e) {
    if (!used[e]) continue;
    const auto& entry = (*this)[static_cast<Expression>(e)];
    if (entry.operation == Operation::variable) {
      made[e] = entry.variable == variable ? one : zero;
    } else if (std::ranges::all_of(entry.arguments, is_constant)) {
      made[e] = zero;
    } else {
      made[e] = derivative_of(Node(entry), made);
    }
  }
  std::vector<Expression> results;
  for (const auto e : of) results.push_back(made[static_cast<std::size_t>(e)]);
  return results;
}

Expression ExpressionPool::derivative(Expression of, int variable) {
  return derivatives({of}, variable).front();
}

}  // namespace fde::bench
