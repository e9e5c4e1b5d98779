#pragma once

#include "numbers/real.hpp"

namespace fde {

// P(s) = sum_i c_i s^(o_i) as a function of w = log s: P(e^w) = sum_i c_i e^(o_i w) is entire, the principal
// sheet is the strip |Im w| <= pi, and what lies beyond the cut of s^(o_i) is simply further up.
template <class Real>
struct Characteristic {
  struct Term {
    Complex<Real> coefficient;
    Real order;
  };
  std::vector<Term> terms;  // increasing orders, no zero coefficient

  // One Newton step for the zeros, P / (dP/dw), with the moduli of P and dP/dw relative to those of the
  // terms.
  struct Step {
    Complex<Real> value;
    Real residual, steepness;
  };
  [[nodiscard]] Step newton_step(const Complex<Real>& w) const;
  // P scaled by a positive number, with which the largest term becomes 1 in modulus.
  [[nodiscard]] Complex<Real> direction(const Complex<Real>& w) const;
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

// All of them, counted by the argument principle; std::runtime_error where search and count do not agree.
std::vector<Zero<long double>> find_zeros(const Characteristic<long double>& characteristic);

// The same zeros to working precision; where there are several together, their centre stays as it is.
template <class Real>
std::vector<Zero<Real>> polished(const Characteristic<Real>& characteristic,
                                 const std::vector<Zero<long double>>& zeros);

extern template struct Characteristic<long double>;
extern template struct Characteristic<BigReal>;

}  // namespace fde
