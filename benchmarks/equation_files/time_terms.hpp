#pragma once

#include <optional>
#include <vector>

#include "equation_files/expressions.hpp"

namespace fde {

// c t^p; with `from` c for t > from, where p is 0. All are expressions without variables.
struct TimeTerm {
  Expression coefficient, power;
  std::optional<Expression> from{};
};

// An expression of t alone, t >= 0, as a sum of such terms; nothing where it is not written as one, or has
// more than a hundred.
std::optional<std::vector<TimeTerm>> time_terms(Expression of, Expressions& all);

// The Caputo derivative from 0 of the sum of c t^p,
//   D^order t^p = Gamma(p+1) / Gamma(p+1-order) t^(p-order), 0 of whole p < ceil(order).
// Nothing where a term is switched, or starts with a power for which there is none.
std::optional<Expression> caputo_derivative(const std::vector<TimeTerm>& terms, double order,
                                            Expressions& all);

}  // namespace fde
