// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <vector>

namespace fde {

using ComplexValue = std::complex<double>;

// exp(z) - 1 without cancellation.
ComplexValue exp_minus_one(ComplexValue z);

// (-mu)^(1-s) Li_s(e^mu) with the polylogarithm Li_s(zeta) = sum_{k>=1} zeta^k / k^s; finite at mu = 0.
// Preconditions: s <= 0, -0.7 <= Re mu <= 0, |Im mu| <= pi. Relative error about 1e-14, except near zeros of
// Li_s.
ComplexValue scaled_polylogarithm(double s, ComplexValue mu);

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
