// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::bench {

// A number as a fraction: itself, or, as for sqrt(2), a fraction so near to it that no double shows the
// difference.
struct ExactNumber {
  reference::Rational value;
  bool is_exact;
};

// The value of an expression without variables. Precondition: the pool has fractions. nullopt if it contains
// a variable or is not finite.
std::optional<ExactNumber> exact_number(Expression of, const ExpressionPool& pool);

}  // namespace fde::bench
