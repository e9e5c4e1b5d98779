#include "closed_forms/power_sum.hpp"

#include <stdexcept>

#include "laplace/contour.hpp"
#include "laplace/refine.hpp"
#include "numbers/bounded.hpp"

namespace fde {
namespace {

template <class Real>
Sum<Real> sum_at(const std::vector<Power>& terms, double order, double t) {
  using std::abs, std::log, std::pow;
  Sum<Real> sum;
  const Real time = decimal<Real>(t);
  for (const auto& [coefficient, power, multiple] : terms) {
    if (coefficient == 0.0) continue;
    const Real exponent = decimal<Real>(power) + decimal<Real>(multiple) * decimal<Real>(order);
    const Real ulps = 4 + (time > 0 ? Real(2 * abs(exponent) * (1 + abs(Real(log(time))))) : Real(0));
    sum.add(Complex<Real>(Real(decimal<Real>(coefficient) * pow(time, exponent))),
            Real(ulps * epsilon<Real>()));
  }
  return sum;
}

std::vector<Bounded<BigReal>> in_digits(const std::vector<Power>& terms, double order, double t, int digits) {
  return refine(digits, 0, [&](int) { return std::vector{sum_at<BigReal>(terms, order, t)}; });
}

DoubleBounded in_double(const std::vector<Power>& terms, double order, double t) {
  const Sum<long double> quick = sum_at<long double>(terms, order, t);
  if (std::isfinite(quick.error) && quick.error <= double_tolerance * std::abs(quick.value))
    return to_double(quick.value, quick.error);
  const Precision precision(contour_precision(double_digits));
  return to_double(in_digits(terms, order, t, double_digits).front());
}

void require_time(double t) {
  if (!(t >= 0.0 && std::isfinite(t)))
    throw std::invalid_argument("power sum: times have to be finite and not negative");
}

}  // namespace

Reference power_sum(const std::vector<Power>& terms, double order) {
  const auto at = [terms, order](double t) {
    require_time(t);
    const auto [value, bound] = in_double(terms, order, t);
    return ReferenceValue{Vec::Constant(1, value.real()), Vec::Constant(1, bound)};
  };
  const auto digits = [terms, order](double t, int wanted) {
    require_time(t);
    const Precision precision(contour_precision(wanted));
    const auto [value, bound] = in_digits(terms, order, t, wanted).front();
    const DecimalText text = write_decimal(real_part<BigReal>(value), bound, wanted);
    return std::vector<Decimal>{{text.value, write_bound(text.bound)}};
  };
  return {at, digits};
}

}  // namespace fde
