// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/closed_forms/power_sum.hpp"

#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/special_functions/laplace/contour.hpp"

namespace fde::reference {
namespace {

template <class Real>
BoundedSum<Real> sum_at(const std::vector<PowerTerm>& terms, double order, double t) {
  using std::abs, std::log, std::pow;
  BoundedSum<Real> sum;
  const Real time = from_shortest_decimal<Real>(t);
  for (const auto& [coefficient, power, multiple] : terms) {
    if (coefficient == 0.0) continue;
    const Real exponent = from_shortest_decimal<Real>(power) +
                          from_shortest_decimal<Real>(multiple) * from_shortest_decimal<Real>(order);
    const Real ulps = 4 + (time > 0 ? Real(2 * abs(exponent) * (1 + abs(Real(log(time))))) : Real(0));
    sum.add(Complex<Real>(Real(from_shortest_decimal<Real>(coefficient) * pow(time, exponent))),
            Real(ulps * epsilon<Real>()));
  }
  return sum;
}

}  // namespace

Reference power_sum(const std::vector<PowerTerm>& terms, double order) {
  const auto quick = [terms, order](double t) -> std::optional<std::vector<BoundedDouble>> {
    const BoundedSum<long double> sum = sum_at<long double>(terms, order, t);
    const bool settled = std::isfinite(sum.error) && sum.error <= double_tolerance * std::abs(sum.value);
    return settled ? std::optional(std::vector{to_double(sum.value, sum.error)}) : std::nullopt;
  };
  const auto precise = [terms, order](double t, int digits) {
    return increase_digits_by_comparison(digits, 0,
                                         [&](int) { return std::vector{sum_at<BigReal>(terms, order, t)}; });
  };
  return as_reference({.name = "power sum", .quick = quick, .precise = precise});
}

}  // namespace fde::reference
