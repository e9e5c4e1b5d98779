#pragma once

#include "weights/exponential_sum.hpp"
#include "weights/weights.hpp"

namespace fde {

// The weights of a family are Laplace integrals over the kernel t^(a-1)/Gamma(a). So a sum of exponentials of
// the kernel gives them when each coefficient is multiplied with a smooth factor. With D(s) = (exp(s) - 1) /
// s:
//
//   rectangle            Gamma(g+1) D               (k^g - (k-1)^g = g int_(k-1)^k t^(g-1) dt)
//   trapezoid            Gamma(g+2) D^2 exp(-s)     (hat function on [k-1, k+1])
//   its start weight     Gamma(g+2) (D - 1)/s       (half a hat)
//   L1                   Gamma(2-g) D exp(-s)       (with a = 1 - g)
//   Grunwald-Letnikov    D^(-a)                     (B(k+g, 1-g) = int_0^inf (e^s - 1)^(-g) e^(-k s) ds)
//
// Weights of orders in (1, 2] grow. Their differences w(k) - w(k-1) are the integrals, with a = g - 1 and one
// more factor D where the rule interpolates. The differences weigh the running sums of the samples.

// a, in (0, 1]. At 1 the weights, or their differences, are constant.
long double kernel_exponent(const WeightTable& table);

// Whether the exponentials give differences of weights, for running sums.
bool weighs_running_sums(const WeightTable& table);

// Whether the family has coefficients, its own, those of the weights that it filters, or of its parts.
bool has_exponentials(const WeightTable& table);

// c_m in w(k) = sum_m c_m exp(-nodes[m] k), or in w(k) - w(k-1) where running sums are weighed. The relative
// error at lag k is that of the kernel's sum at the times [k - 2, k + 1]; for Grunwald-Letnikov [k, k + 2].
Vec weight_coefficients(const WeightTable& table, const ExponentialSum& sum);

// The same for start_weight(k), where the family has a start_coefficient.
Vec start_coefficients(const WeightTable& table, const ExponentialSum& sum);

}  // namespace fde
