// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/numbers/real.hpp"

// Quotients for closed forms of motions, accurate where numerator and denominator vanish.
namespace fde::reference {

// sin x / x; 1 at 0.
template <class Real>
Real sine_quotient(const Real& x) {
  using std::sin;
  return x == 0 ? Real(1) : Real(sin(x) / x);
}

// artanh x / x, |x| < 1; 1 at 0.
template <class Real>
Real artanh_quotient(const Real& x) {
  using std::atanh;
  return x == 0 ? Real(1) : Real(atanh(x) / x);
}

// (x - sin x) / x^2; 0 at 0. For |x| <= 1 by its series x/3! - x^3/5! + ..., where the difference would
// cancel.
template <class Real>
Real sine_defect(const Real& x) {
  using std::abs, std::sin;
  if (abs(x) > 1) return Real((x - sin(x)) / (x * x));
  Real term = x / 6, sum = term;
  for (int k = 4; abs(term) > epsilon<Real>() * abs(sum); k += 2) {
    term *= -x * x / (k * (k + 1));
    sum += term;
  }
  return sum;
}

}  // namespace fde::reference
