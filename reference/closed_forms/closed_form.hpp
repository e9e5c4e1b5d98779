#pragma once

#include "numbers/real.hpp"
#include "reference.hpp"

namespace fde {

// One column of a closed form and the size of what it is put together from: the sum of its terms without
// their signs, each times how strongly it answers to relative changes of time and parameters (at least 1).
template <class Real>
struct Rounded {
  Real value, size;
};

// The columns at a time, in long double and at the precision that is set.
struct ClosedForm {
  std::function<std::vector<Rounded<long double>>(double t)> quick;
  std::function<std::vector<Rounded<BigReal>>(double t)> precise;
};

// As a reference. Its bound allows each column closed_form_units roundings of its size.
// Both throw std::invalid_argument for a time that is negative or not finite.
Reference closed_form_reference(const ClosedForm& form);
inline constexpr int closed_form_units = 32;

// The same of a function of a Real t, for Real = long double and BigReal, to std::vector<Rounded<Real>>.
template <class Columns>
Reference closed_form(const Columns& columns) {
  return closed_form_reference({[columns](double t) { return columns(decimal<long double>(t)); },
                                [columns](double t) { return columns(decimal<BigReal>(t)); }});
}

}  // namespace fde
