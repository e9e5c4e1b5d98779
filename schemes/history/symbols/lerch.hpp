// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/history/weights/polylogarithm.hpp"

namespace fde {

// Lerch's function Phi(zeta, s, a) = sum_{k>=0} zeta^k (k + a)^(-s) for fixed s in [-2, 0] and a in (0, 1],
// by Hurwitz zeta functions (Bateman, vol. 1, 1.11 (8)): for |mu| < 2 pi
//   exp(a mu) Phi(exp(mu), s, a) = Gamma(1-s) (-mu)^(s-1) + sum_{k>=0} zeta(s-k, a) mu^k / k!
class Lerch {
 public:
  Lerch(double s, double a);

  // (-mu)^(1-s) Phi(e^mu, s, a), finite at mu = 0. Preconditions: -0.7 <= Re mu <= 0, |Im mu| <= pi.
  [[nodiscard]] ComplexValue scaled(ComplexValue mu) const;

 private:
  double s_, a_;
  std::vector<double> coefficients_;  // zeta(s-k, a) / k!
};

// Hurwitz's zeta(-p, a), the analytic continuation of sum_{k>=0} (k + a)^p. Preconditions: p >= 0, 0 < a
// <= 1.
long double hurwitz_zeta_at_minus(long double p, long double a);

}  // namespace fde
