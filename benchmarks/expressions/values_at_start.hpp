// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde::bench {

// The expressions of t >= 0 (variable 0) and y with quotients of t alone that are 0/0 at t = 0 continued to
// their limits: next to t = 0 by the Taylor series, whose coefficients follow from the derivatives of both
// parts, where these exist (de l'Hospital). sin(t)/t becomes 1 at t = 0, and (1 - cos(t))/t^2 has no
// cancellation there.
std::vector<Expression> with_limits_at_start(const std::vector<Expression>& of, ExpressionPool& pool);

// The first part of the expression that is not a number at (t, y), although its own parts are; nullopt if the
// expression is a number or infinite there.
std::optional<Expression> not_a_number(Expression of, double t, In y, const ExpressionPool& pool);

// The expressions of t (variable 0) and y_i (variable i + 1) as expressions of t and z_i = y_i - origin_i
// (variable i + 1). The constants of sums are collected, so that a difference y_i - origin_i, or y_i - y_j
// with equal origins, has no rounding. nullopt: no constants cancel.
std::optional<std::vector<Expression>> in_increments(const std::vector<Expression>& of, const Vec& origin,
                                                     ExpressionPool& pool);

}  // namespace fde::bench
