// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"

namespace fde::bench {

// c t^p; with `from`: c (t - from)^p for t > from, 0 before, and p a whole number. All are expressions
// without variables.
struct TimeTerm {
  Expression coefficient, power;
  std::optional<Expression> from{};
};

// An expression of t, 0 <= t <= end, as a sum of such terms; nullopt if it is not of this form or has more
// than 2000 terms. Only floor(a + b t) depends on the end: it has one term for each of its steps.
std::optional<std::vector<TimeTerm>> time_terms(Expression of, ExpressionPool& pool,
                                                double end = std::numeric_limits<double>::infinity());

// The fractional integral of the term c t^p, c Gamma(p+1) / Gamma(p+1+order) t^(p+order); with a negative
// order its derivative. Precondition: the term has no `from`.
Operand integral(const TimeTerm& term, Operand order);

// The Caputo derivative from 0 of the sum of c t^p,
//   D^order t^p = Gamma(p+1) / Gamma(p+1-order) t^(p-order), 0 of integer p < ceil(order).
// nullopt if a term has `from`, or if the derivative of a power does not exist.
std::optional<Expression> caputo_derivative(const std::vector<TimeTerm>& terms, double order,
                                            ExpressionPool& pool);

}  // namespace fde::bench
