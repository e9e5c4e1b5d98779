// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/reference/reference.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// One column of a closed form, and the sum of the moduli of its terms, each times its relative sensitivity
// (at least 1) to time and parameters.
template <class Real>
struct ConditionedValue {
  Real value, size;
};

// The columns at a time, in long double and at the current precision.
struct ClosedForm {
  std::function<std::vector<ConditionedValue<long double>>(double t)> quick;
  std::function<std::vector<ConditionedValue<BigReal>>(double t)> precise;
};

// The Reference of a closed form; in double its bound is closed_form_rounding_factor epsilon size for each
// column. Both functions of the reference throw std::invalid_argument for a time that is negative or not
// finite.
Reference closed_form_reference(const ClosedForm& form);
inline constexpr int closed_form_rounding_factor = 32;

// The same for a function object that maps a Real t to std::vector<ConditionedValue<Real>>, Real = long
// double and BigReal.
template <class Columns>
Reference closed_form(const Columns& columns) {
  return closed_form_reference(
      {[columns](double t) { return columns(from_shortest_decimal<long double>(t)); },
       [columns](double t) { return columns(from_shortest_decimal<BigReal>(t)); }});
}

// Real columns as functions of time, in long double and in multiprecision, for as_reference().
struct Evaluation {
  std::string name;  // prefix of the error messages
  // Evaluation in long double, rounded to double; nullopt where it is not accurate enough. Optional.
  std::function<std::optional<std::vector<BoundedDouble>>(double t)> quick{};
  // Each column to a relative accuracy of `digits` decimal digits. Precondition: a Precision is in force.
  std::function<std::vector<Bounded<BigReal>>(double t, int digits)> precise;
  double end = std::numeric_limits<double>::infinity();  // times are finite and in [0, end]
};

// The columns at time t: those of `quick`, or else of `precise` with double_digits digits, rounded to double.
std::vector<BoundedDouble> evaluate_in_double(const Evaluation& evaluation, double t);

// Both functions of the reference throw std::invalid_argument if t is not finite or outside [0, end], and
// digits(t, digits) also if digits < 1.
Reference as_reference(const Evaluation& evaluation);

// Quotients for closed forms of motions, accurate where numerator and denominator vanish.
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
