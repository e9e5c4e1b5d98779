// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/algebra.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fde::bench::mechanics {
namespace {

Expressions each(const Expressions& a, const std::function<Expression(std::size_t i)>& value) {
  Expressions result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(value(i));
  return result;
}

}  // namespace

Expressions Algebra::numbers(const Eigen::VectorXd& values) const {
  Expressions all;
  for (const double value : values) all.push_back(number(value));
  return all;
}

Expressions Algebra::variables(const std::vector<int>& indices) const {
  Expressions all;
  for (const int i : indices) all.push_back(pool_.variable(i));
  return all;
}

ExpressionMatrix Algebra::column(const Expressions& entries) const {
  ExpressionMatrix result(entries.size(), 1, zero_);
  result.entries = entries;
  return result;
}

Expression Algebra::sum(Expression a, Expression b) const {
  if (pool_[b].operation == Operation::negate) return difference(a, pool_[b].arguments[0]);
  if (pool_[a].operation == Operation::negate) return difference(b, pool_[a].arguments[0]);
  return pool_.make_expression(Operation::add, a, b);
}

Expression Algebra::difference(Expression a, Expression b) const {
  if (a == b) return zero_;
  if (pool_[b].operation == Operation::negate) return sum(a, pool_[b].arguments[0]);
  return pool_.make_expression(Operation::subtract, a, b);
}

Expression Algebra::product(Expression a, Expression b) const {
  const auto is_minus_one = [&](Expression e) {
    return pool_[e].operation == Operation::number && pool_[e].value == -1.0L;
  };
  if (is_minus_one(a)) return negative(b);
  if (is_minus_one(b)) return negative(a);
  if (pool_[a].operation == Operation::negate) return negative(product(pool_[a].arguments[0], b));
  if (pool_[b].operation == Operation::negate) return negative(product(a, pool_[b].arguments[0]));
  return pool_.make_expression(Operation::multiply, a, b);
}

Expression Algebra::quotient(Expression a, Expression b) const {
  if (is_zero(a)) return zero_;
  return pool_.make_expression(Operation::divide, a, b);
}

Expression Algebra::negative(Expression a) const { return pool_.make_expression(Operation::negate, a); }

Expressions Algebra::sum(const Expressions& a, const Expressions& b) const {
  return each(a, [&](std::size_t i) { return sum(a[i], b[i]); });
}

Expressions Algebra::difference(const Expressions& a, const Expressions& b) const {
  return each(a, [&](std::size_t i) { return difference(a[i], b[i]); });
}

Expressions Algebra::product(Expression factor, const Expressions& a) const {
  return each(a, [&](std::size_t i) { return product(factor, a[i]); });
}

Expressions Algebra::negative(const Expressions& a) const {
  return each(a, [&](std::size_t i) { return negative(a[i]); });
}

Expression Algebra::dot(const Expressions& a, const Expressions& b) const {
  Expression total = zero_;
  for (std::size_t i = 0; i < a.size(); ++i) total = sum(total, product(a[i], b[i]));
  return total;
}

Expressions Algebra::product(const ExpressionMatrix& a, const Expressions& x) const {
  return product(a, column(x)).entries;
}

ExpressionMatrix Algebra::product(const ExpressionMatrix& a, const ExpressionMatrix& b) const {
  ExpressionMatrix result(a.rows, b.columns, zero_);
  for (std::size_t i = 0; i < a.rows; ++i) {
    for (std::size_t j = 0; j < b.columns; ++j) {
      for (std::size_t k = 0; k < a.columns; ++k) result(i, j) = sum(result(i, j), product(a(i, k), b(k, j)));
    }
  }
  return result;
}

ExpressionMatrix Algebra::transposed(const ExpressionMatrix& a) const {
  ExpressionMatrix result(a.columns, a.rows, zero_);
  for (std::size_t i = 0; i < a.rows; ++i) {
    for (std::size_t j = 0; j < a.columns; ++j) result(j, i) = a(i, j);
  }
  return result;
}

ExpressionMatrix Algebra::solve(ExpressionMatrix a, ExpressionMatrix b) const {
  const auto subtract_row = [&](ExpressionMatrix& from, std::size_t row, Expression factor, std::size_t by) {
    for (std::size_t j = 0; j < from.columns; ++j)
      from(row, j) = difference(from(row, j), product(factor, from(by, j)));
  };
  for (std::size_t k = 0; k < a.rows; ++k) {
    std::size_t pivot = k;
    while (pivot + 1 < a.rows && is_zero(a(pivot, k))) ++pivot;
    for (std::size_t j = 0; j < a.columns && pivot != k; ++j) std::swap(a(k, j), a(pivot, j));
    for (std::size_t j = 0; j < b.columns && pivot != k; ++j) std::swap(b(k, j), b(pivot, j));
    for (std::size_t i = k + 1; i < a.rows; ++i) {
      if (is_zero(a(i, k))) continue;
      const auto factor = quotient(a(i, k), a(k, k));
      subtract_row(a, i, factor, k);
      subtract_row(b, i, factor, k);
      a(i, k) = zero_;
    }
  }
  for (std::size_t k = a.rows; k-- > 0;) {
    for (std::size_t j = 0; j < b.columns; ++j) {
      for (std::size_t i = k + 1; i < a.rows; ++i) b(k, j) = difference(b(k, j), product(a(k, i), b(i, j)));
      b(k, j) = quotient(b(k, j), a(k, k));
    }
  }
  return b;
}

ExpressionMatrix Algebra::jacobian(const Expressions& f, const std::vector<int>& variables) const {
  ExpressionMatrix result(f.size(), variables.size(), zero_);
  for (std::size_t j = 0; j < variables.size() && !f.empty(); ++j) {
    const auto column = pool_.derivatives(f, variables[j]);
    for (std::size_t i = 0; i < f.size(); ++i) result(i, j) = column[i];
  }
  result.entries = simplified(result.entries);
  return result;
}

Algebra::Scaled Algebra::split(Expression e) const {
  const ExpressionPool::Node entry = pool_[e];
  if (entry.operation == Operation::negate) {
    const auto inner = split(entry.arguments[0]);
    return {negative(inner.factor), inner.rest};
  }
  if (entry.operation != Operation::multiply) return {pool_.number(1), e};
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    if (pool_[entry.arguments[i]].operation == Operation::number)
      return {entry.arguments[i], entry.arguments[1 - i]};
  }
  return {pool_.number(1), e};
}

// nullopt if the factor is neither a double nor a fraction.
std::optional<Expression> Algebra::joined(const Scaled& of) const {
  const auto exact = pool_[of.factor].value;
  const auto factor = static_cast<double>(exact);
  if (pool_[of.factor].operation != Operation::number || !std::isfinite(factor)) return std::nullopt;
  if (pool_.has_fractions()) return product(of.factor, of.rest);
  if (static_cast<long double>(factor) != exact) return std::nullopt;
  return product(number(factor), of.rest);
}

std::optional<Expression> Algebra::simplified(Operation operation, Expression a, Expression b) const {
  const auto first = split(a), second = split(b);
  const auto made = [&](Operation of, Expression x, Expression y) { return pool_.make_expression(of, x, y); };
  switch (operation) {
    case Operation::add:
    case Operation::subtract:
      if (first.rest != second.rest) return std::nullopt;
      return joined({made(operation, first.factor, second.factor), first.rest});
    case Operation::multiply: {
      const auto& number_of = pool_[a].operation == Operation::number ? a : b;
      if (pool_[number_of].operation == Operation::number) {
        const auto other = number_of == a ? second : first;
        return joined({made(operation, number_of, other.factor), other.rest});
      }
      const auto rest = product(std::min(first.rest, second.rest), std::max(first.rest, second.rest));
      return joined({made(operation, first.factor, second.factor), rest});
    }
    case Operation::divide:
      if (pool_[b].operation != Operation::number) return std::nullopt;
      return joined({made(operation, first.factor, b), first.rest});
    default:
      return std::nullopt;
  }
}

Expressions Algebra::simplified(const Expressions& of) const {
  const auto simple = [&](Expression e, const ExpressionPool::Node& node, const auto& parts) {
    const Expression a = parts(0), b = parts(1);
    if (a == ExpressionPool::none) return e;
    if (b != ExpressionPool::none)
      if (const auto known = simplified(node.operation, a, b)) return *known;
    if (node.operation == Operation::add) return sum(a, b);
    if (node.operation == Operation::subtract) return difference(a, b);
    return pool_.with_arguments(node, a, b, parts(2));
  };
  return values_from_parts(pool_, of, ExpressionPool::none, simple);
}

Expressions Algebra::gradient(Expression f, const std::vector<int>& variables) const {
  return jacobian({f}, variables).entries;
}

}  // namespace fde::bench::mechanics
