// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <vector>

namespace fde::reference {

struct RootOnSheet {
  std::complex<long double> logarithm;  // its imaginary part determines the sheet
  std::complex<long double> value;      // its modulus is limited to e^11000
};

// The s with s^alpha = z on the sheet |arg s| <= pi, alpha in (0, 5]. A root on the cut is listed for both of
// its sides, unless alpha is an integer: then there is no cut.
std::vector<RootOnSheet> roots_on_sheet(long double alpha, std::complex<long double> log_z);

}  // namespace fde::reference
