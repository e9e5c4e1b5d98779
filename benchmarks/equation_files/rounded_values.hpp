// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::bench {

// The values at a time of expressions of t, with the size of the summands of each value (ConditionedValue,
// closed_form.hpp), propagated by the derivatives of the operations. Numbers are those written, or else their
// long double values. `rows`: the values of the variables 1, 2, ..., if the expressions contain such.
std::vector<reference::ConditionedValue<long double>> rounded_values(
    const ExpressionPool& pool, const std::vector<Expression>& of, const long double& time,
    const std::vector<reference::ConditionedValue<long double>>& rows = {});
std::vector<reference::ConditionedValue<reference::BigReal>> rounded_values(const ExpressionPool& pool,
                                                                            const std::vector<Expression>& of,
                                                                            const reference::BigReal& time);

}  // namespace fde::bench
