// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/laplace/contour.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"

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

void require_time(const Evaluation& evaluation, double t) {
  if (t >= 0.0 && t <= evaluation.end && std::isfinite(t)) return;
  throw std::invalid_argument(
      std::isfinite(evaluation.end)
          ? fmt::format("{}: t = {} has to be in [0, {}]", evaluation.name, t, evaluation.end)
          : fmt::format("{}: times have to be finite and not negative", evaluation.name));
}

ReferenceValue value_at(const Evaluation& evaluation, double t) {
  require_time(evaluation, t);
  const auto columns = evaluate_in_double(evaluation, t);
  ReferenceValue known{Vec(std::ssize(columns)), Vec(std::ssize(columns))};
  Eigen::Index next = 0;
  for (const auto& [value, bound] : columns) {
    known.value[next] = value.real();
    known.bound[next++] = bound;
  }
  return known;
}

std::vector<Decimal> digits_at(const Evaluation& evaluation, double t, int digits) {
  require_time(evaluation, t);
  if (digits < 1)
    throw std::invalid_argument(fmt::format("{}: the number of digits has to be positive", evaluation.name));
  const Precision precision(contour_precision(digits));
  std::vector<Decimal> texts;
  for (const auto& [value, bound] : evaluation.precise(t, digits)) {
    const DecimalText text = to_decimal_text(real_part<BigReal>(value), bound, digits);
    texts.push_back({text.value, to_bound_text(text.bound)});
  }
  return texts;
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

std::vector<BoundedDouble> evaluate_in_double(const Evaluation& evaluation, double t) {
  if (evaluation.quick) {
    if (const auto columns = evaluation.quick(t)) return *columns;
  }
  const Precision precision(contour_precision(double_digits));
  std::vector<BoundedDouble> columns;
  for (const auto& column : evaluation.precise(t, double_digits)) columns.push_back(to_double(column));
  return columns;
}

Reference as_reference(const Evaluation& evaluation) {
  return {.at = [evaluation](double t) { return value_at(evaluation, t); },
          .digits = [evaluation](double t, int digits) { return digits_at(evaluation, t, digits); },
          .evidence = Evidence::closed_form};
}

}  // namespace fde::reference
