// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/stepping/rates.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Fractional Adams-Bashforth-Moulton predictor-corrector in PE(CE)^m form, m = options.corrections:
//   y_n^P = T_n + h^g/Gamma(g+1) sum_{j<n} b_{n-j} f_j,
//   y_n   = T_n + h^g/Gamma(g+2) (a_{0,n} f_0 + sum_{1<=j<n} a_{n-j} f_j + f(t_n, y_n^P)),
// with the Taylor part T_n and the weights b of the product rectangle, a of the product trapezoidal rule.
Trajectory predict_and_correct(const Problem& problem, const Grid& grid, const Options& options);

// Linear interpolation of f, evaluated at a prediction by the rectangle rule: the error h of the prediction
// enters with the factor h^g of the corrector, so the rate is min(2, 1 + g) (Diethelm, Ford & Freed 2004,
// theorem 3.2).
extern const RateTheory predictor_corrector_theory;

}  // namespace fde
