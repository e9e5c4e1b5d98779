// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::bench {

// The values at a time of expressions of t whose numbers are stored as written, with the size of the summands
// of each value (ConditionedValue, closed_form.hpp), propagated by the derivatives of the operations.
std::vector<reference::ConditionedValue<long double>> rounded_values(const ExpressionPool& pool,
                                                                     const std::vector<Expression>& of,
                                                                     const long double& time);
std::vector<reference::ConditionedValue<reference::BigReal>> rounded_values(const ExpressionPool& pool,
                                                                            const std::vector<Expression>& of,
                                                                            const reference::BigReal& time);

}  // namespace fde::bench
