#pragma once

#include "numbers/real.hpp"

namespace fde {

// P(s) = sum_i c_i s^(o_i) as a function of w = log s: P(e^w) = sum_i c_i e^(o_i w) is entire, the principal
// sheet is the strip |Im w| <= pi, and what lies beyond the cut of s^(o_i) is simply further up.
template <class Real>
struct Characteristic {
  struct Term {
    Complex<Real> log_coefficient;
    Real order;
  };
  std::vector<Term> terms;  // increasing orders, no zero coefficient

  // The terms at w, divided by the modulus of the largest.
  [[nodiscard]] std::vector<Complex<Real>> scaled_terms(const Complex<Real>& w) const;
  // P / (dP/dw), the step of Newton's method.
  [[nodiscard]] Complex<Real> newton_step(const Complex<Real>& w) const;
  // Of the terms, the logarithms of their moduli.
  [[nodiscard]] std::vector<Real> log_sizes(const Complex<Real>& w) const;
};

// A zero of P, or several that are too close to be told apart, inside the strip: those on the cut need no
// correction on a contour round it.
template <class Real>
struct Zero {
  Complex<Real> log;
  int multiplicity = 1;
  long double spread = 0.0L;                                        // of the several
  long double isolation = std::numeric_limits<long double>::max();  // distance of the next zero
};

// The same zeros to working precision; where there are several together, their centre stays as it is.
template <class Real>
std::vector<Zero<Real>> polished(const Characteristic<Real>& characteristic,
                                 const std::vector<Zero<long double>>& zeros);

extern template struct Characteristic<long double>;
extern template struct Characteristic<BigReal>;

}  // namespace fde
