#pragma once

#include <cmath>

namespace fde {

// log|Gamma(x)|. std::lgamma leaves the sign in a global variable, where threads race.
inline double log_gamma(double x) {
  int sign = 0;
  return lgamma_r(x, &sign);
}

}  // namespace fde
