// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <functional>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The symbol S of a scheme applied to D^(g_i) y_i = (A y)_i with a constant step size. The generating
// functions Y(zeta) = sum_n y_n zeta^n and F of A y satisfy Y = K F + (a term of the initial values), hence S
// F = (a term of the initial values). At a zero of det S with |zeta| < 1 some initial values make y_n grow
// like |zeta|^(-n), times a power of n at a multiple zero. If det S has no zero in |zeta| <= 1, y_n -> 0
// (Wiener's theorem: Lubich, IMA J. Numer. Anal. 6 (1986)). As for generating_function the argument is log
// zeta.
//
// With K_w the diagonal matrix of step factor times generating function of the weights w, S is
//   implicit rules       I - A K
//   predict, evaluate,   I - A (K_a - k + k A K_b), a the trapezoidal and b the rectangle weights, k the
//   correct, evaluate    step factor of a, the weight of the newest sample
// A Symbol returns S with column i multiplied by (1-zeta)^g_i, which has no zero in |zeta| < 1 and
// makes S bounded. Schemes that split orders have the symbol of the split problem.
using Symbol = std::function<ComplexMatrix(std::complex<double> log_zeta)>;

}  // namespace fde
