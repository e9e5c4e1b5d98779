// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// P(s) = sum_i c_i s^(o_i) as a function of w = log s: P(e^w) = sum_i c_i e^(o_i w) is entire, the principal
// sheet is the strip |Im w| <= pi, and the other sheets continue it above and below.
template <class Real>
struct ExponentialPolynomial {
  struct Term {
    Complex<Real> log_coefficient;
    Real order;
  };
  std::vector<Term> terms;  // increasing orders, no zero coefficient

  // The terms at w, divided by the largest modulus.
  [[nodiscard]] std::vector<Complex<Real>> scaled_terms(const Complex<Real>& w) const;
  // P / (dP/dw), the step of Newton's method.
  [[nodiscard]] Complex<Real> newton_step(const Complex<Real>& w) const;
  // The logarithms of the moduli of the terms at w.
  [[nodiscard]] std::vector<Real> log_sizes(const Complex<Real>& w) const;
};

// A zero of P inside the strip, or a cluster of zeros that are too close to be separated. Zeros on the cut
// need no correction on a contour around it.
template <class Real>
struct Zero {
  Complex<Real> log;  // log s*; of a cluster, the mean
  int multiplicity = 1;
  long double radius = 0.0L;                                        // radius of the cluster
  long double isolation = std::numeric_limits<long double>::max();  // distance from the nearest other zero
};

// The zeros to working precision, by Newton's method; the centre of a cluster is not changed.
template <class Real>
std::vector<Zero<Real>> newton_refined(const ExponentialPolynomial<Real>& characteristic,
                                       const std::vector<Zero<long double>>& zeros);

extern template struct ExponentialPolynomial<long double>;
extern template struct ExponentialPolynomial<BigReal>;

}  // namespace fde::reference
