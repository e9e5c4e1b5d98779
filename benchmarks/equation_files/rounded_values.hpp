#pragma once

#include <vector>

#include "closed_forms/closed_form.hpp"
#include "equation_files/expressions.hpp"
#include "numbers/real.hpp"

namespace fde {

// The values of expressions of t at a time, whose numbers are kept as they were written, with the size of
// what each was put together from (closed_form.hpp): by the derivatives of its operations.
std::vector<Rounded<long double>> rounded_values(const Expressions& all, const std::vector<Expression>& of,
                                                 const long double& time);
std::vector<Rounded<BigReal>> rounded_values(const Expressions& all, const std::vector<Expression>& of,
                                             const BigReal& time);

}  // namespace fde
