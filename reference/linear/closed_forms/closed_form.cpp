// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"

#include "fdebench/reference/linear/closed_forms/evaluation.hpp"
#include "fdebench/reference/special_functions/laplace/adaptive_precision_contour.hpp"

namespace fde::reference {
namespace {

template <class Real>
Real rounding_of(const ConditionedValue<Real>& column) {
  return Real(closed_form_rounding_factor * epsilon<Real>() * column.size);
}

std::vector<BoundedDouble> in_long_double(const ClosedForm& form, double t) {
  std::vector<BoundedDouble> columns;
  for (const auto& column : form.quick(t)) columns.push_back(to_double(column.value, rounding_of(column)));
  return columns;
}

std::vector<BoundedSum<BigReal>> sums_at(const ClosedForm& form, double t) {
  std::vector<BoundedSum<BigReal>> sums;
  for (const auto& column : form.precise(t)) {
    BoundedSum<BigReal> sum;
    sum.value = BigComplex(column.value);
    sum.error = rounding_of(column);
    sum.scale = column.size;
    sums.push_back(sum);
  }
  return sums;
}

}  // namespace

Reference closed_form_reference(const ClosedForm& form) {
  return as_reference({.name = "closed form",
                       .quick = [form](double t) { return in_long_double(form, t); },
                       .precise =
                           [form](double t, int digits) {
                             return increase_digits_by_comparison(digits, 0,
                                                                  [&](int) { return sums_at(form, t); });
                           }});
}

}  // namespace fde::reference
