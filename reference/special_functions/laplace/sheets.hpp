// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// log z on a sheet of the logarithm: log z + 2 pi i sheet. Divided by alpha it is the logarithm of a solution
// s of s^alpha = z, one per sheet.
template <class Real>
Complex<Real> log_on_sheet(const Complex<Real>& log_z, int sheet) {
  return {real_part<Real>(log_z), Real(imag_part<Real>(log_z) + 2 * sheet * pi<Real>())};
}

}  // namespace fde::reference
