// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde::bench {

// The expressions of t (variable 0) and y_i (variable i + 1) as expressions of t and z_i = y_i - origin_i
// (variable i + 1). The constants of sums are collected, so that a difference y_i - origin_i, or y_i - y_j
// with equal origins, has no rounding. nullopt: no constants cancel.
std::optional<std::vector<Expression>> in_increments(const std::vector<Expression>& of, const Vec& origin,
                                                     ExpressionPool& pool);

}  // namespace fde::bench
