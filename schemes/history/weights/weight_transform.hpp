// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/weights/exponential_sum.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"

namespace fde {

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
