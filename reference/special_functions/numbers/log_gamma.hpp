// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace fde::reference {

// log|Gamma(x)|. std::lgamma stores the sign in a global variable, a data race between threads.
inline double log_gamma(double x) {
  int sign = 0;
  return lgamma_r(x, &sign);
}

}  // namespace fde::reference
