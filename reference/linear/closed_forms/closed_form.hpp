// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/reference.hpp"
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

}  // namespace fde::reference
