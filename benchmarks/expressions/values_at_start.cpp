// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/values_at_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fdebench/benchmarks/expressions/apply.hpp"

namespace fde::bench {

namespace {

using Series = std::vector<long double>;  // Taylor coefficients at t = 0

std::optional<long double> value_at_start(Expression of, ExpressionPool& pool) {
  const auto value = pool.value(pool.without_variables(of, 0));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

// As many coefficients as derivatives of moderate length give, up to `most`.
Series taylor_series(Expression of, std::size_t most, ExpressionPool& pool) {
  constexpr Expression longest = 4000;  // expressions that the derivatives may add
  Series series;
  long double factorial = 1.0L;
  const Expression first = of;
  for (std::size_t k = 0; k < most && of - first < longest; ++k) {
    if (k > 0) factorial *= static_cast<long double>(k);
    const auto value = value_at_start(of, pool);
    if (!value) break;
    series.push_back(*value / factorial);
    try {
      of = pool.derivative(of, 0);
    } catch (const std::invalid_argument&) {  // it has none
      break;
    }
  }
  return series;
}

// The series of a quotient with a removable singularity; empty for another one.
Series quotient(const Series& a, const Series& b) {
  const auto first_of = [](const Series& x) {
    return static_cast<std::size_t>(std::ranges::find_if(x, [](auto c) { return c != 0.0L; }) - x.begin());
  };
  const std::size_t first = first_of(b), count = std::min(a.size(), b.size());
  if (first >= count || first_of(a) < first) return {};
  Series q;
  for (std::size_t k = first; k < count; ++k) {
    long double sum = a[k];
    for (std::size_t j = 0; j < q.size(); ++j) sum -= q[j] * b[k - j];
    q.push_back(sum / b[first]);
  }
  return q;
}

// Up to which time the polynomial equals the function to rounding, by the decay of its coefficients.
double reach(const Series& q) {
  constexpr long double rounding = 1e-17L;
  const long double largest = std::ranges::max(q, {}, [](auto c) { return std::abs(c); });
  long double rate = 0.0L;
  for (std::size_t k = 1; k < q.size(); ++k) {
    rate = std::max(rate, std::pow(std::abs(q[k] / (largest == 0.0L ? 1.0L : std::abs(largest))),
                                   1.0L / static_cast<long double>(k)));
  }
  const long double part = std::pow(rounding, 1.0L / static_cast<long double>(q.size()));
  return static_cast<double>(rate == 0.0L ? part : part / rate);
}

// q(max(t, d)) for t > d, and the polynomial P(min(t, d)) before.
Expression continued(Expression of, const Series& q, ExpressionPool& pool) {
  const auto number = [&](long double value) {
    return Operand{&pool, pool.number(fmt::format("{}", static_cast<double>(value)))};
  };
  const Operand until = number(reach(q)), t{&pool, pool.variable(0)};
  const Operand early = t.of(Operation::min, until.value), late = t.of(Operation::max, until.value);
  Operand polynomial = number(q.back());
  for (std::size_t k = q.size() - 1; k-- > 0;) polynomial = polynomial * early + number(q[k]);
  const Operand is_late = sign(late - until);
  const Operand later{&pool, pool.substituted({of}, [&](int) { return late.value; }).front()};
  return (is_late * later + (1 - is_late) * polynomial).value;
}

std::optional<Expression> with_limit(Expression of, ExpressionPool& pool) {
  constexpr std::size_t most = 14;
  const auto [operation, arguments] = std::pair(pool[of].operation, pool[of].arguments);
  if (operation != Operation::divide || pool.depends_on_unknowns(of) || !pool.depends_on(of, 0))
    return std::nullopt;
  const auto [a, b, none] = arguments;
  if (value_at_start(a, pool) != 0.0L || value_at_start(b, pool) != 0.0L) return std::nullopt;
  // The Taylor series of a table says nothing of it behind its first samples.
  const auto is_table = [](const ExpressionPool::Node& node) { return node.function != nullptr; };
  if (!pool.arguments({of}, is_table).empty()) return std::nullopt;
  const Series q = quotient(taylor_series(a, most, pool), taylor_series(b, most, pool));
  return q.empty() ? std::nullopt : std::optional(continued(of, q, pool));
}

// An expression as a sum of a part that varies, or 0, and a constant.
struct Sum {
  Expression varying;
  long double constant;
};

class Rewriting {
 public:
  Rewriting(const Vec& origin, ExpressionPool& pool) : origin_(origin), pool_(pool), zero_(pool.number(0)) {}

  [[nodiscard]] bool has_cancelled() const { return has_cancelled_; }

  Expression whole(const Sum& sum) {
    if (sum.constant == 0.0L) return sum.varying;
    return pool_.make_expression(Operation::add, sum.varying,
                                 pool_.number(fmt::format("{}", static_cast<double>(sum.constant))));
  }

  // The sum of an operation on these sums; the node is that of expression e.
  Sum rewritten(Expression e, const ExpressionPool::Node& node, const std::array<Sum, 3>& of) {
    switch (node.operation) {
      case Operation::number:
        return {zero_, node.value};
      case Operation::variable:
        return {e, node.variable == 0 ? 0.0L : origin_[node.variable - 1]};
      case Operation::add:
      case Operation::subtract:
        return combined(node.operation, of[0], of[1]);
      case Operation::negate:
        return {pool_.make_expression(Operation::negate, of[0].varying), -of[0].constant};
      case Operation::multiply:
        if (of[0].varying == zero_ || of[1].varying == zero_) return scaled(of[0], of[1]);
        break;
      case Operation::divide:
        if (of[1].varying == zero_) {
          return {pool_.make_expression(Operation::divide, of[0].varying, whole(of[1])),
                  of[0].constant / of[1].constant};
        }
        break;
      default:
        break;
    }
    return {pool_.with_arguments(node, whole(of[0]), whole(of[1]), whole(of[2])), 0.0L};
  }

 private:
  // Constants cancel where they are equal to half a unit in the last place of double: an origin is rounded.
  Sum combined(Operation operation, const Sum& a, const Sum& b) {
    constexpr long double rounding = std::numeric_limits<double>::epsilon() / 2.0L;
    const Expression varying = pool_.make_expression(operation, a.varying, b.varying);
    const long double constant =
        operation == Operation::add ? a.constant + b.constant : a.constant - b.constant;
    const long double largest = std::max(std::abs(a.constant), std::abs(b.constant));
    const bool cancel = largest > 0.0L && std::abs(constant) <= rounding * largest;
    has_cancelled_ = has_cancelled_ || (cancel && varying != zero_);
    return {varying, cancel ? 0.0L : constant};
  }

  // A product in which one factor is constant.
  Sum scaled(const Sum& a, const Sum& b) {
    const Expression x = a.varying == zero_ ? whole(a) : a.varying,
                     y = b.varying == zero_ ? whole(b) : b.varying;
    const bool varies = a.varying != zero_ || b.varying != zero_;
    return {varies ? pool_.make_expression(Operation::multiply, x, y) : zero_, a.constant * b.constant};
  }

  const Vec& origin_;
  ExpressionPool& pool_;
  Expression zero_;
  bool has_cancelled_ = false;
};

}  // namespace

std::vector<Expression> with_limits_at_start(const std::vector<Expression>& of, ExpressionPool& pool) {
  constexpr auto none = ExpressionPool::none;
  return values_from_parts(
      pool, of, none, [&](Expression e, const ExpressionPool::Node& node, const auto& parts) {
        const std::array replaced{parts(0), parts(1), parts(2)};
        if (const auto limit = with_limit(e, pool)) return *limit;
        return replaced == node.arguments ? e : pool.with_arguments(node, parts(0), parts(1), parts(2));
      });
}

std::optional<Expression> not_a_number(Expression of, double t, In y, const ExpressionPool& pool) {
  std::optional<Expression> first;
  const auto values = values_from_parts(
      pool, {of}, 0.0L, [&](Expression e, const ExpressionPool::Node& node, const auto& parts) {
        const long double value =
            node.operation == Operation::variable
                ? (node.variable == 0 ? static_cast<long double>(t) : y[node.variable - 1])
            : node.operation == Operation::number ? node.value
                                                  : apply(node, parts(0), parts(1), parts(2));
        if (std::isnan(value) && !first) first = e;
        return value;
      });
  return std::isnan(values.front()) ? first : std::nullopt;
}

std::optional<std::vector<Expression>> in_increments(const std::vector<Expression>& of, const Vec& origin,
                                                     ExpressionPool& pool) {
  Rewriting rewriting(origin, pool);
  const auto sums =
      values_from_parts(pool, of, Sum{ExpressionPool::none, 0.0L},
                        [&](Expression e, const ExpressionPool::Node& node, const auto& parts) {
                          return rewriting.rewritten(e, node, std::array{parts(0), parts(1), parts(2)});
                        });
  if (!rewriting.has_cancelled()) return std::nullopt;
  std::vector<Expression> results;
  for (const auto& sum : sums) results.push_back(rewriting.whole(sum));
  return results;
}

}  // namespace fde::bench
