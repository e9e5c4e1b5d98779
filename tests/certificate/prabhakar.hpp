#pragma once

#include <string>
#include <vector>

#include "certificate/ball.hpp"

namespace fde::certificate {

// E^gamma_{alpha,beta}(z) or, with derivative > 0, that derivative of E_{alpha,beta}; every number is the
// double it is.
struct PrabhakarPoint {
  double alpha, beta, gamma;
  std::complex<double> z;
  int derivative = 0;
};

// The same each time: even ones are derivatives, 1 to 8, odd ones Prabhakar's function with any gamma.
// |z|^(1/alpha), the size of the singularities s*, is at most 100, which the power series can do.
constexpr double largest_pole = 100.0;
PrabhakarPoint prabhakar_point(int index);

// Encloses the value to at least that many digits by its power series: with r_j = |z| |gamma + j| / (j + 1)
// Gamma(x) / Gamma(x + alpha), x = alpha j + beta, what follows a term t is at most |t| r/(1 - r), r the
// larger of r_j and its limit in the first quotient. Throws std::runtime_error where 4000 bits do not do.
Ball prabhakar_enclosure(const PrabhakarPoint& x, int digits);

struct PrabhakarJudgement {
  PrabhakarPoint point;
  double ulps = 0.0;  // |error| in units of the last place of the value
  double seconds = 0.0;
  std::vector<std::string> faults{};
};

// The double: inside its stated bound, and the bound at most 8 ulp of the value.
PrabhakarJudgement judge(const PrabhakarPoint& point);

}  // namespace fde::certificate
