#pragma once

#include <complex>
#include <vector>

namespace fde {

struct RootOnSheet {
  std::complex<long double> logarithm;  // which names the sheet
  std::complex<long double> value;      // at most e^11000 in size
};

// The s with s^alpha = z on the sheet |arg s| <= pi, alpha in (0, 5]. Of a root on the cut both copies,
// unless alpha is whole: then they are one, and there is no cut.
std::vector<RootOnSheet> roots_on_sheet(long double alpha, std::complex<long double> log_z);

}  // namespace fde
