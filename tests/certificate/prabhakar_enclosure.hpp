// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "certificate/ball.hpp"

namespace fde::reference::certificate {

// E^gamma_{alpha,beta}(z) or, with derivative > 0, that derivative of E_{alpha,beta}; the doubles are taken
// exactly.
struct PrabhakarPoint {
  double alpha, beta, gamma;
  std::complex<double> z;
  int derivative = 0;
};

// Deterministic: for even indices derivatives 1 to 8, for odd ones Prabhakar's function with any gamma. The
// modulus |z|^(1/alpha) of the singularities s* is at most 100, within reach of the power series.
constexpr double largest_pole = 100.0;
PrabhakarPoint prabhakar_point(int index);

// Encloses the value with at least `digits` digits by its power series: with
// r_j = |z| |gamma + j| / (j + 1) Gamma(x) / Gamma(x + alpha), x = alpha j + beta, the remainder after a term
// t is at most |t| r/(1 - r), r being r_j with the first quotient replaced by max(1, |gamma + j| / (j + 1)).
// Throws std::runtime_error where 4000 bits do not suffice.
Ball prabhakar_enclosure(const PrabhakarPoint& x, int digits);

struct PrabhakarCheck {
  PrabhakarPoint point;
  double ulps = 0.0;  // |error| in units of the last place of the value
  double seconds = 0.0;
  std::vector<std::string> failures{};
};

// Checks the value in double: its error is within the stated bound, and the bound is at most 8 ulp of the
// value.
PrabhakarCheck check_point(const PrabhakarPoint& point);

}  // namespace fde::reference::certificate
