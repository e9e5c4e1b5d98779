#pragma once

#include <complex>

#include "weights/weights.hpp"

namespace fde {

using ComplexValue = std::complex<double>;

// W(zeta) = w(0) + sum_{k>=1} w(k) zeta^k at zeta = exp(log_zeta) next to and on the unit circle but for zeta
// = 1: -0.7 <= Re log_zeta <= 0, |Im log_zeta| <= pi, log_zeta != 0. w(0), the weight of the newest sample,
// is 1 for the implicit families and 0 for the rectangle rule, which has none. Relative error about 1e-14,
// but next to zeros of W (rectangle: zeta = -1 at order 2; trapezoid: zeta = -1 at order 1). With the
// polylogarithm Li_s = sum_{k>=1} zeta^k / k^s:
//
//   rectangle            (1-zeta) Li_(-g)
//   trapezoid            (1-zeta)^2/zeta Li_(-g-1)
//   Grunwald-Letnikov    (1-zeta)^(-g)
//   L1                   (1-zeta)/zeta Li_(g-1)
//
// The logarithm is the argument since small orders ask for points that are nearer to 1 than doubles are.
ComplexValue generating_function(const WeightTable& table, ComplexValue log_zeta);

// (1-zeta)^g K(zeta), where K turns f into y: W, and 1 / ((1-zeta) W) for L1, whose weights are those of y.
// Bounded for |zeta| <= 1, however near to 1.
ComplexValue regular_part(const WeightTable& table, ComplexValue log_zeta);

// (1-zeta)^order
ComplexValue difference_power(double order, ComplexValue log_zeta);

}  // namespace fde
