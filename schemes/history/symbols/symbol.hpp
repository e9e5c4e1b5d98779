// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <functional>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The symbol S of a scheme applied to D^(g_i) y_i = (A y + sum_k B_k y(t - lag_k))_i with a constant step
// size. The generating functions Y(zeta) = sum_n y_n zeta^n and F of the right-hand side satisfy Y = K F + (a
// term of the initial values), hence S F = (a term of the initial values). At a zero of det S with |zeta| < 1
// some initial values make y_n grow like |zeta|^(-n), times a power of n at a multiple zero. If det S has no
// zero in |zeta| <= 1, y_n -> 0 (Wiener's theorem: Lubich, IMA J. Numer. Anal. 6 (1986)). As for
// generating_function the argument is log zeta.
//
// With K_w the diagonal matrix of step factor times generating function of the weights w and N(zeta) that of
// the earlier values (DelayedPart), S is
//   implicit rules       I - (A + N) K
//   predict, evaluate,   I - A (K_a - k + k A K_b) - R' N R^-1 (K_a + k A K_b), a the trapezoidal and b the
//   correct, evaluate    rectangle weights, k the step factor of a, the weight of the newest sample
// with R = I + k A and R' = I + A k: the corrector takes the earlier values themselves, not predictions of
// them, so that F = (A + N) Y and R Y = (K_a + k A K_b) F. det S is that of R - (K_a + k A K_b) (A + N).
//
// A Symbol returns S with column i multiplied by (1-zeta)^g_i, which has no zero in |zeta| < 1 and
// makes S bounded. Schemes that split orders have the symbol of the split problem.
using Symbol = std::function<ComplexMatrix(std::complex<double> log_zeta)>;

}  // namespace fde
