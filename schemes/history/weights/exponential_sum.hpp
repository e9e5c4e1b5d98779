// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/weights/weights.hpp"
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

// The weights of a family are means of the kernel t^(a-1)/Gamma(a). A sum of exponentials for the kernel
// therefore gives a sum of exponentials for the weights: each coefficient is multiplied with a smooth factor.
// With D(s) = (exp(s) - 1) / s the factors are
//
//   rectangle            Gamma(g+1) D               (k^g - (k-1)^g = g int_(k-1)^k t^(g-1) dt)
//   trapezoid            Gamma(g+2) D^2 exp(-s)     (hat function on [k-1, k+1])
//   its weight of x_0    Gamma(g+2) (D - 1)/s       (half a hat)
//   L1                   Gamma(2-g) D exp(-s)       (with a = 1 - g)
//   Grunwald-Letnikov    D^(-a)                     (B(k+g, 1-g) = int_0^inf (e^s - 1)^(-g) e^(-k s) ds)
//
// For orders in (1, 2] the weights grow with k. There the sum of exponentials represents the differences
// w(k) - w(k-1), with a = g - 1 and one more factor D for the interpolating rules, and the differences are
// applied to the running sums of the samples.

// The exponent a of the kernel, in (0, 1]. At a = 1 the weights, or their differences, are constant.
long double kernel_exponent(const WeightTable& table);

// Whether the sum of exponentials gives the differences of the weights, applied to running sums.
bool acts_on_running_sums(const WeightTable& table);

// Whether the family has a sum of exponentials: its own, through its filter, or through its two parts.
bool has_exponential_sum(const WeightTable& table);

// The c_m in w(k) = sum_m c_m exp(-nodes[m] k), or in w(k) - w(k-1) where running sums are weighed. The
// relative error at lag k is at most the error of the kernel's sum at times in [k - 2, k + 1]; for
// Grunwald-Letnikov in [k, k + 2].
Vec weight_coefficients(const WeightTable& table, const ExponentialSum& sum);

// The same for first_sample_weight(k). Precondition: the family has a first_sample_coefficient.
Vec first_sample_coefficients(const WeightTable& table, const ExponentialSum& sum);

}  // namespace fde
