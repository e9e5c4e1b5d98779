#include "closed_forms/closed_form.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "laplace/contour.hpp"
#include "laplace/refine.hpp"
#include "numbers/bounded.hpp"

namespace fde {
namespace {

void require_time(double t) {
  if (!(t >= 0.0 && std::isfinite(t)))
    throw std::invalid_argument(fmt::format("t = {}: must be a finite number, at least 0", t));
}

template <class Real>
Real rounding_of(const Rounded<Real>& column) {
  return Real(closed_form_units * epsilon<Real>() * column.size);
}

ReferenceValue in_double(const ClosedForm& form, double t) {
  require_time(t);
  const auto columns = form.quick(t);
  ReferenceValue known{Vec(std::ssize(columns)), Vec(std::ssize(columns))};
  Eigen::Index next = 0;
  for (const auto& column : columns) {
    const auto [value, bound] = to_double(column.value, rounding_of(column));
    known.value[next] = value.real();
    known.bound[next++] = bound;
  }
  return known;
}

std::vector<Decimal> in_digits(const ClosedForm& form, double t, int digits) {
  require_time(t);
  const Precision precision(contour_precision(digits));
  const auto columns = refine(digits, 0, [&](int) {
    std::vector<Sum<BigReal>> sums;
    for (const auto& column : form.precise(t)) {
      Sum<BigReal> sum;
      sum.value = BigComplex(column.value);
      sum.error = rounding_of(column);
      sum.scale = column.size;
      sums.push_back(sum);
    }
    return sums;
  });
  std::vector<Decimal> written;
  for (const auto& [value, bound] : columns) {
    const DecimalText text = write_decimal(real_part<BigReal>(value), bound, digits);
    written.push_back({text.value, write_bound(text.bound)});
  }
  return written;
}

}  // namespace

Reference closed_form_reference(const ClosedForm& form) {
  return {[form](double t) { return in_double(form, t); },
          [form](double t, int digits) { return in_digits(form, t, digits); }};
}

}  // namespace fde
