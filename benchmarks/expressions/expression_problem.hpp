// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// Row `row` of a right-hand side has no derivative with respect to an unknown.
struct DerivativeError : std::invalid_argument {
  DerivativeError(Eigen::Index row_index, const std::string& what)
      : std::invalid_argument(what), row(row_index) {}
  Eigen::Index row;
};

// y(t - lag) of a row.
struct EarlierValue {
  Eigen::Index row;
  double lag;
  bool operator==(const EarlierValue&) const = default;
};

// What right-hand sides with delays look up: with n rows, values[k] is variable n + 1 + k, and before[i] is
// row i for t < 0, a function of t.
struct EarlierValues {
  std::vector<EarlierValue> values{};
  std::vector<Expression> before{};
};

// The problem D^(order_i) y_i = as_given[i], expressions of t (variable 0) and y_j (variable j + 1), with
// quotients of t that are 0/0 at t = 0 continued to their limits: f, df/dy (a matrix if f is linear in y with
// constant coefficients) and the switching functions, which are the arguments of sign, step and floor that
// depend on y. Where df/dy is not finite at the initial values and f contains differences from them, also f
// and df/dy as functions of these (IncrementForm). Throws DerivativeError. Switching functions must not
// contain earlier values.
Problem expression_problem(std::vector<Component> components, const std::vector<Expression>& as_given,
                           double end, ExpressionPool& pool, const EarlierValues& earlier = {});

}  // namespace fde::bench
