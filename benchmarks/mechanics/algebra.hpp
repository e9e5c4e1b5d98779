// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"

namespace fde::bench::mechanics {

using Expressions = std::vector<Expression>;

// A matrix of expressions, stored by rows.
struct ExpressionMatrix {
  std::size_t rows = 0, columns = 0;
  Expressions entries{};

  ExpressionMatrix(std::size_t row_count, std::size_t column_count, Expression value)
      : rows(row_count), columns(column_count), entries(row_count * column_count, value) {}
  Expression& operator()(std::size_t i, std::size_t j) { return entries[i * columns + j]; }
  Expression operator()(std::size_t i, std::size_t j) const { return entries[i * columns + j]; }
};

// Sums, products, derivatives and linear systems of expressions. Vectors and matrices must have fitting
// sizes. The pool must outlive this object.
class Algebra {
 public:
  explicit Algebra(ExpressionPool& pool) : pool_(pool), zero_(pool.number(0)) {}

  [[nodiscard]] ExpressionPool& pool() const { return pool_; }
  [[nodiscard]] Expression zero() const { return zero_; }
  [[nodiscard]] bool is_zero(Expression e) const { return e == zero_; }
  [[nodiscard]] Expression number(double value) const { return pool_.number(value); }
  [[nodiscard]] Expressions numbers(const Eigen::VectorXd& values) const;
  [[nodiscard]] Expressions variables(const std::vector<int>& indices) const;

  [[nodiscard]] Expression sum(Expression a, Expression b) const;
  [[nodiscard]] Expression difference(Expression a, Expression b) const;
  [[nodiscard]] Expression product(Expression a, Expression b) const;
  [[nodiscard]] Expression quotient(Expression a, Expression b) const;
  [[nodiscard]] Expression negative(Expression a) const;

  [[nodiscard]] Expressions sum(const Expressions& a, const Expressions& b) const;
  [[nodiscard]] Expressions difference(const Expressions& a, const Expressions& b) const;
  [[nodiscard]] Expressions product(Expression factor, const Expressions& a) const;
  [[nodiscard]] Expressions negative(const Expressions& a) const;
  [[nodiscard]] Expression dot(const Expressions& a, const Expressions& b) const;

  [[nodiscard]] Expressions product(const ExpressionMatrix& a, const Expressions& x) const;
  [[nodiscard]] ExpressionMatrix product(const ExpressionMatrix& a, const ExpressionMatrix& b) const;
  [[nodiscard]] ExpressionMatrix transposed(const ExpressionMatrix& a) const;

  // a^-1 b by Gaussian elimination. The diagonal entries are the pivots, which is stable for symmetric
  // positive definite a; an entry that is 0 as an expression is exchanged with one below it. Precondition: a
  // is not singular as a matrix of expressions.
  [[nodiscard]] ExpressionMatrix solve(ExpressionMatrix a, ExpressionMatrix b) const;
  [[nodiscard]] Expressions solve(const ExpressionMatrix& a, const Expressions& b) const {
    return solve(a, column(b)).entries;
  }

  // The expressions with like terms added and constant factors multiplied: (x*2)/2 is x, sin(x)*cos(x) +
  // cos(x)*sin(x) is 2*sin(x)*cos(x). Equal to rounding.
  [[nodiscard]] Expressions simplified(const Expressions& of) const;

  // d f_i / d variable j, simplified.
  [[nodiscard]] ExpressionMatrix jacobian(const Expressions& f, const std::vector<int>& variables) const;
  [[nodiscard]] Expressions gradient(Expression f, const std::vector<int>& variables) const;

 private:
  [[nodiscard]] ExpressionMatrix column(const Expressions& entries) const;
  // factor * rest, the factor being a number.
  struct Scaled {
    Expression factor;
    Expression rest;
  };
  [[nodiscard]] Scaled split(Expression e) const;
  [[nodiscard]] std::optional<Expression> joined(const Scaled& of) const;
  [[nodiscard]] std::optional<Expression> simplified(Operation operation, Expression a, Expression b) const;

  ExpressionPool& pool_;
  Expression zero_;
};

}  // namespace fde::bench::mechanics
