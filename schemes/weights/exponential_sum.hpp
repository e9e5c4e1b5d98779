#pragma once

#include "problem/problem.hpp"

namespace fde {

// The kernel of a fractional integral as a short sum of decaying exponentials:
//   t^(a-1) / Gamma(a) = sum_m coefficients[m] exp(-nodes[m] t) (1 + e),  |e| <= bound for low <= t <= high.
struct ExponentialSum {
  Vec nodes;  // increasing, >= 0
  Vec coefficients;
  double bound = 0.0;  // computed from the construction; rounding of nodes and coefficients comes on top
};

// The sum for exponent a in (0, 1]. It starts from the integral
//   t^(a-1) / Gamma(a) = sin(pi a)/pi int_0^inf s^(-a) exp(-s t) ds,  s = exp(x),
// takes the trapezoidal rule in x, leaves out the nodes far above 1/low, and replaces the infinitely many
// below about 10/high by their own Gauss rule: they lie geometrically, so that its polynomials are the little
// q-Jacobi ones. docs/history.md derives the three parts of the bound. Exponent 1 is the constant 1: one
// node at 0.
//
// The exponent is extended because 1 - order of L1 may not be a double, which would count at long times.
// Throws std::invalid_argument unless 0 < a <= 1, 0 < low < high < infinity and 0 < tolerance < 1.
ExponentialSum exponential_sum(long double exponent, double low, double high, double tolerance);

}  // namespace fde
