// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <vector>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// log z on a sheet of the logarithm: log z + 2 pi i sheet. Divided by alpha it is the logarithm of a solution
// s of s^alpha = z, one per sheet.
template <class Real>
Complex<Real> log_on_sheet(const Complex<Real>& log_z, int sheet) {
  return {real_part<Real>(log_z), Real(imag_part<Real>(log_z) + 2 * sheet * pi<Real>())};
}

struct RootOnSheet {
  std::complex<long double> logarithm;  // its imaginary part determines the sheet
  std::complex<long double> value;      // its modulus is limited to e^11000
};

// The s with s^alpha = z on the sheet |arg s| <= pi, alpha in (0, 5]. A root on the cut is listed for both of
// its sides, unless alpha is an integer: then there is no cut.
std::vector<RootOnSheet> roots_on_sheet(long double alpha, std::complex<long double> log_z);

}  // namespace fde::reference
