// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// A sum of decaying exponentials that approximates the kernel of a fractional integral:
//   t^(a-1) / Gamma(a) = sum_m coefficients[m] exp(-nodes[m] t) (1 + e),  |e| <= bound for low <= t <= high.
struct ExponentialSum {
  Vec nodes;  // increasing, >= 0
  Vec coefficients;
  double bound = 0.0;  // a priori; does not include the rounding of nodes and coefficients
};

// The sum for the exponent a in (0, 1] with bound <= tolerance. The integral
//   t^(a-1) / Gamma(a) = sin(pi a)/pi int_0^inf s^(-a) exp(-s t) ds,  s = exp(x),
// is discretised by the trapezoidal rule in x. Nodes far above 1/low are omitted. The infinitely many nodes
// below about 10/high are replaced by a Gauss rule; because they are a geometric sequence, its orthogonal
// polynomials are the little q-Jacobi polynomials. docs/history.md derives the three parts of the bound.
// Exponent 1 is the constant 1: one node at 0.
//
// The exponent is a long double because 1 - order of L1 may not be a double, which matters at long times.
// Throws std::invalid_argument unless 0 < a <= 1, 0 < low < high < infinity and 0 < tolerance < 1.
ExponentialSum exponential_sum(long double exponent, double low, double high, double tolerance);

}  // namespace fde
