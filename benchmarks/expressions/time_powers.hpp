// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde::bench {

// The exponent p of an expression t^p or sqrt(t); integer powers are not stored as such.
std::optional<double> power_of_time(const ExpressionPool& pool, const ExpressionPool::Node& entry);

// The values at t = 0, y = start of the expressions that these consist of, by expression, and 0 for others.
std::vector<double> values_of_parts(const ExpressionPool& pool, const std::vector<Expression>& of, In start);

// The non-integer powers of t in an expression of t and y; nullopt if it is otherwise not smooth where its
// parts have these values.
std::optional<std::set<double>> time_powers(const ExpressionPool& pool, Expression of,
                                            const std::vector<double>& values);

// The same of several expressions together, at t = 0 and y = start.
std::optional<std::set<double>> powers_of_time(const ExpressionPool& pool, const std::vector<Expression>& of,
                                               In start);

}  // namespace fde::bench
