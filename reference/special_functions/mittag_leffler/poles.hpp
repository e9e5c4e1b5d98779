// SPDX-License-Identifier: MIT
#pragma once

#include <boost/container/static_vector.hpp>

#include "fdebench/reference/special_functions/laplace/sheets.hpp"

namespace fde::reference {

// A pole s*^alpha = z, log s* = (log z + 2 pi i sheet) / alpha.
template <class Real>
struct Pole {
  int sheet;
  Complex<Real> log;
};

// As alpha <= 5, the poles with |arg s*| < 2 pi are on the sheets -max_sheet, ..., max_sheet.
inline constexpr int max_sheet = 6;
template <class T>
using PerSheet = boost::container::static_vector<T, 2 * max_sheet + 1>;

template <class Real>
struct Poles {
  PerSheet<Pole<Real>> on_near_sheets{};  // those with |arg s*| < 2 pi
  // Of the other poles, as in ContourBound::Quotient.
  double nearest_other_argument = std::numeric_limits<double>::infinity();
};

// The poles on the sheets first_sheet, ..., max_sheet. Poles nearer to 0 than the range of double count as
// poles on another sheet.
template <class Real>
Poles<Real> poles_of(const Real& alpha, const Complex<Real>& log_z, int first_sheet = -max_sheet) {
  using std::abs;
  constexpr double most_log = 600.0, most_log_of_contour = 20.0;
  const Real log_size = real_part<Real>(log_z);
  const bool next_to_zero = log_size / alpha < -most_log;
  Poles<Real> poles;
  const auto on_far_sheets = [&](const Real& distance) {
    poles.nearest_other_argument = std::min(poles.nearest_other_argument, static_cast<double>(distance));
  };
  for (int sheet = first_sheet; sheet <= max_sheet; ++sheet) {
    const Complex<Real> log = log_on_sheet<Real>(log_z, sheet);
    const Real argument = abs(imag_part<Real>(log));
    if (next_to_zero) {
      on_far_sheets(Real(-log_size - most_log_of_contour * alpha));
    } else if (argument < 2 * pi<Real>() * alpha) {
      poles.on_near_sheets.push_back({sheet, Complex<Real>(log / alpha)});
    } else {
      on_far_sheets(argument);
    }
  }
  return poles;
}

}  // namespace fde::reference
