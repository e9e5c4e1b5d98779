// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"

namespace fde::bench {

// A function of the end T that gives the times > 0, increasing, at which the rows jump as functions of t:
// those declared in the file, and those up to T at which the argument of a sign or a step changes sign, if it
// depends on t only. Sign changes are searched on 8192 equal steps of [0, T] and at T/2, T/4, ... near 0, and
// located to the last bit; two changes within one of these steps are missed.
std::function<std::vector<double>(double end)> time_jumps(const std::vector<Expression>& rows,
                                                          std::vector<double> declared,
                                                          const ExpressionPool& pool);

}  // namespace fde::bench
