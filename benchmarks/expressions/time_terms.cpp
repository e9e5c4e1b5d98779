// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/time_terms.hpp"

#include <fmt/format.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "fdebench/benchmarks/expressions/sampled_function.hpp"

namespace fde::bench {
namespace {

using Terms = std::optional<std::vector<TimeTerm>>;

constexpr std::size_t most_terms = 2000;

// Computes the terms of an expression from those of its arguments, by rules for sums, products and powers.
class TimeTermRules {
 public:
  TimeTermRules(ExpressionPool& pool, double end) : pool_(pool), end_(end) {}

  Terms of(Operation operation, const Terms& a, const Terms& b) {
    switch (operation) {
      case Operation::add:
        return sum(a, b);
      case Operation::subtract:
        return sum(a, product(one(pool_.number(-1), pool_.number(0)), b));
      case Operation::negate:
        return product(one(pool_.number(-1), pool_.number(0)), a);
      case Operation::multiply:
        return product(a, b);
      case Operation::divide:
        return product(a, power(b, pool_.number(-1)));
      case Operation::power:
        if (!b || b->size() != 1 || !is_constant(b->front())) return std::nullopt;
        return power(a, b->front().coefficient);
      case Operation::sqrt:
        return power(a, pool_.number("0.5"));
      case Operation::step:
        return step(a);
      case Operation::floor:
        return floor(a);
      default:
        return std::nullopt;
    }
  }

  // A table of a + b t: the polynomial in which t = 0 is, and at each later sample the change to the next
  // one. Of cubic pieces these changes grow far beyond the table, so that their sum has few digits.
  Terms sampled(const SampledFunction& function, const Terms& argument) {
    const auto line = affine(argument);
    if (!line || function.jumping_derivative() > 1 || function.pieces() > most_terms) return std::nullopt;
    const auto [start, rate] = *line;
    const auto first = pool_.value(start.value), slope = pool_.value(rate.value);
    if (!first || !slope || !(*first >= function.first() && *first <= function.last())) return std::nullopt;
    std::size_t piece = function.pieces() - 1;
    while (piece > 0 && function.start(piece) > static_cast<double>(*first)) --piece;
    std::vector<TimeTerm> terms;
    const auto add = [&, by = rate](const std::vector<Operand>& taylor, std::optional<Expression> from) {
      Operand scale = number(1.0);
      for (std::size_t k = 0; k < taylor.size(); ++k, scale = scale * by) {
        const auto coefficient = taylor[k] * scale;
        if (pool_.value(coefficient.value) != 0.0L)
          terms.push_back({coefficient.value, pool_.number(static_cast<int>(k)), from});
      }
    };
    add(moved(taylor_of(function, piece), start - number(function.start(piece))), std::nullopt);
    while (*slope > 0.0L ? piece + 1 < function.pieces() : *slope < 0.0L && piece > 0) {
      const std::size_t upper = *slope > 0.0L ? ++piece : piece--, lower = upper - 1;
      const Operand sample = number(function.start(upper));
      auto change = taylor_of(function, upper);
      const auto below = moved(taylor_of(function, lower), sample - number(function.start(lower)));
      for (std::size_t k = 0; k < change.size(); ++k)
        change[k] = *slope > 0.0L ? change[k] - below[k] : below[k] - change[k];
      add(change, ((sample - start) / rate).value);
    }
    return terms;
  }

  [[nodiscard]] Terms constant(Expression value) { return one(value, pool_.number(0)); }
  [[nodiscard]] Terms time() { return one(pool_.number(1), pool_.number(1)); }

 private:
  static Terms one(Expression coefficient, Expression power) {
    return std::vector<TimeTerm>{{coefficient, power}};
  }
  Expression made(Operation operation, Expression a, Expression b) {
    return pool_.make_expression(operation, a, b);
  }
  [[nodiscard]] bool is_constant(const TimeTerm& term) const {
    return !term.from && pool_.value(term.power) == 0.0L;
  }

  static Terms sum(Terms a, const Terms& b) {
    if (!a || !b || a->size() + b->size() > most_terms) return std::nullopt;
    a->insert(a->end(), b->begin(), b->end());
    return a;
  }

  Terms product(const Terms& a, const Terms& b) {
    if (!a || !b || a->size() * b->size() > most_terms) return std::nullopt;
    std::vector<TimeTerm> terms;
    for (const auto& x : *a) {
      for (const auto& y : *b) {
        const bool is_first = start_of(x) < start_of(y);
        const auto& [earlier, later] = is_first ? std::tie(x, y) : std::tie(y, x);
        const auto moved = start_of(x) == start_of(y) ? std::vector{earlier} : from_start_of(later, earlier);
        if (!moved) return std::nullopt;
        for (const auto& one : *moved) {
          terms.push_back({made(Operation::multiply, one.coefficient, later.coefficient),
                           made(Operation::add, one.power, later.power), later.from ? later.from : one.from});
        }
      }
    }
    return terms;
  }

  [[nodiscard]] long double start_of(const TimeTerm& term) const {
    return term.from ? pool_.value(*term.from).value_or(0.0L) : 0.0L;
  }

  // c (t - a)^p from the start b of a later term on: c sum_k binomial(p, k) (b - a)^(p-k) (t - b)^k; nullopt
  // unless p is a small whole number.
  Terms from_start_of(const TimeTerm& later, const TimeTerm& term) {
    constexpr long double most = 8.0L;
    const auto known = pool_.value(term.power);
    if (!known || *known < 0.0L || *known > most || *known != std::floor(*known)) return std::nullopt;
    const int power = static_cast<int>(*known);
    const auto start = term.from ? *term.from : pool_.number(0);
    const auto shift = made(Operation::subtract, *later.from, start);
    std::vector<TimeTerm> terms;
    int binomial = 1;
    for (int k = 0; k <= power; ++k) {
      const auto scale = made(Operation::multiply, pool_.number(binomial),
                              made(Operation::power, shift, pool_.number(power - k)));
      terms.push_back({made(Operation::multiply, term.coefficient, scale), pool_.number(k), later.from});
      binomial = binomial * (power - k) / (k + 1);
    }
    return terms;
  }

  Terms power(const Terms& a, Expression exponent) {
    if (!a || a->size() != 1 || a->front().from) return std::nullopt;
    const auto& [coefficient, power, from] = a->front();
    return one(made(Operation::power, coefficient, exponent), made(Operation::multiply, power, exponent));
  }

  Operand number(double value) { return {&pool_, pool_.number(fmt::format("{}", value))}; }

  std::vector<Operand> taylor_of(const SampledFunction& function, std::size_t piece) {
    return function.coefficients(piece, [&](double sample) { return number(sample); });
  }

  // The coefficients of a polynomial of x as those of the same one of x - by.
  static std::vector<Operand> moved(std::vector<Operand> taylor, Operand by) {
    for (std::size_t i = 0; i + 1 < taylor.size(); ++i)
      for (std::size_t k = taylor.size() - 1; k-- > i;) taylor[k] = taylor[k] + by * taylor[k + 1];
    return taylor;
  }

  // a and b of the sum a + b t; nullopt for another one.
  std::optional<std::pair<Operand, Operand>> affine(const Terms& of) {
    if (!of) return std::nullopt;
    Operand constant_part = number(0.0), slope = number(0.0);
    for (const auto& term : *of) {
      const auto power = pool_.value(term.power);
      if (term.from || (power != 0.0L && power != 1.0L)) return std::nullopt;
      auto& part = power == 0.0L ? constant_part : slope;
      part = part + Operand{&pool_, term.coefficient};
    }
    return std::pair(constant_part, slope);
  }

  // step(a0 + a1 t): 1 after the zero of its argument if a1 > 0, before it if a1 < 0.
  Terms step(const Terms& a) {
    const auto line = affine(a);
    const auto rise = line ? pool_.value(line->second.value) : std::nullopt;
    if (!rise || *rise == 0.0L) return std::nullopt;
    const auto from = (-(line->first / line->second)).value;
    const bool rises = *rise > 0.0L;
    if (pool_.value(from) <= 0.0L) return constant(pool_.number(rises ? 1 : 0));
    const TimeTerm behind{pool_.number(rises ? 1 : -1), pool_.number(0), from};
    return rises ? std::vector{behind} : std::vector{TimeTerm{pool_.number(1), pool_.number(0)}, behind};
  }

  // floor(a0 + a1 t): its value at 0, and one more, or one less, after each time at which the argument is a
  // whole number.
  Terms floor(const Terms& a) {
    const auto line = affine(a);
    if (!line) return std::nullopt;
    const auto& [first, rate] = *line;
    const auto slope = pool_.value(rate.value), start = pool_.value(first.value);
    if (!slope || !start || !(std::abs(*slope) * end_ <= static_cast<long double>(most_terms)))
      return std::nullopt;
    const bool rises = *slope > 0.0L;
    Operand value = first.of(Operation::floor), next = rises ? value + 1 : value;
    const Operand step = number(rises ? 1.0 : -1.0);
    std::vector<TimeTerm> terms;
    for (; *slope != 0.0L; next = next + step) {
      const auto from = ((next - first) / rate).value;
      const auto time = pool_.value(from);
      if (!time || *time >= static_cast<long double>(end_)) break;
      if (*time > 0.0L) {
        terms.push_back({step.value, pool_.number(0), from});
      } else {
        value = value + step;
      }
    }
    terms.push_back({value.value, pool_.number(0)});
    return terms;
  }

  ExpressionPool& pool_;
  double end_;
};

// The terms of an expression that is no sum.
Terms terms_of_part(Expression of, ExpressionPool& pool, double end) {
  struct Part {
    Terms terms{};
    bool varies = false;
  };
  TimeTermRules rules(pool, end);
  const auto part_of = [&](Expression e, const ExpressionPool::Node& node, const auto& parts) {
    if (node.operation == Operation::variable) return Part{node.variable == 0 ? rules.time() : Terms(), true};
    const bool varies = parts(0).varies || parts(1).varies || parts(2).varies;
    if (!varies) return Part{rules.constant(e), false};
    return Part{node.function ? rules.sampled(*node.function, parts(0).terms)
                              : rules.of(node.operation, parts(0).terms, parts(1).terms),
                true};
  };
  return values_from_parts(pool, {of}, Part{}, part_of).front().terms;
}

}  // namespace

Terms time_terms(Expression of, ExpressionPool& pool, double end) {
  TimeTermRules rules(pool, end);
  std::vector<TimeTerm> terms;
  std::vector<std::pair<Expression, bool>> open{{of, false}};  // summands, and whether they are subtracted
  for (std::size_t parts = 0; !open.empty(); ++parts) {
    const auto [part, is_negative] = open.back();
    open.pop_back();
    const auto [operation, arguments] = std::pair(pool[part].operation, pool[part].arguments);
    const bool is_difference = operation == Operation::subtract;
    if (is_difference || operation == Operation::add) {
      open.emplace_back(arguments[1], is_negative != is_difference);
      open.emplace_back(arguments[0], is_negative);
    } else if (operation == Operation::negate) {
      open.emplace_back(arguments[0], !is_negative);
    } else {
      auto some = terms_of_part(part, pool, end);
      if (is_negative) some = rules.of(Operation::negate, some, {});
      if (!some) return std::nullopt;
      terms.insert(terms.end(), some->begin(), some->end());
    }
    if (terms.size() > most_terms || parts > 4 * most_terms) return std::nullopt;
  }
  return terms;
}

Operand integral(const TimeTerm& term, Operand order) {
  const Operand power{order.pool, term.power}, coefficient{order.pool, term.coefficient}, next = power + 1;
  const auto ratio = next.of(Operation::gamma) / (next + order).of(Operation::gamma);
  return coefficient * ratio * pow({order.pool, order.pool->variable(0)}, power + order);
}

std::optional<Expression> caputo_derivative(const std::vector<TimeTerm>& terms, double order,
                                            ExpressionPool& pool) {
  const Operand minus_order{&pool, pool.number(fmt::format("{}", -order))};
  Operand sum{&pool, pool.number(0)};
  for (const auto& term : terms) {
    const auto p = pool.value(term.power);
    if (term.from || !p || *p < 0.0L) return std::nullopt;
    const bool is_integer = *p == std::floor(*p);
    if (is_integer && static_cast<double>(*p) < std::ceil(order)) continue;
    if (static_cast<double>(*p) <= std::ceil(order) - 1.0) return std::nullopt;
    sum = sum + integral(term, minus_order);
  }
  return sum.value;
}

}  // namespace fde::bench
