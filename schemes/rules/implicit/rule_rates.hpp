// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/stepping/rates.hpp"

namespace fde {

// The theories of the rules that are a scheme of their own and, in integrated form, one for multi-term
// equations.

// The product trapezoidal rule: h^2, and the rates of linear interpolation of f.
extern const RateTheory trapezoidal_theory;

// Backward Euler convolution quadrature: h; a power p has the error h^p at the first step.
extern const RateTheory grunwald_letnikov_theory;

}  // namespace fde
