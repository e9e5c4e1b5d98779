#pragma once

#include "numbers/real.hpp"

namespace fde {

// log z on a sheet of the logarithm: log z + 2 pi i sheet. The s with s^alpha = z have this over alpha for
// their logarithms, one a sheet.
template <class Real>
Complex<Real> log_on_sheet(const Complex<Real>& log_z, int sheet) {
  return {real_part<Real>(log_z), Real(imag_part<Real>(log_z) + 2 * sheet * pi<Real>())};
}

}  // namespace fde
