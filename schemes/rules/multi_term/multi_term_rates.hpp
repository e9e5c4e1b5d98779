// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/weights/family.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Theoretical rates of the integrated equations (integrated_equations.hpp), of the rows D^v u that are
// measured.
//
// Trapezoidal rule: h^2. A power t^q with which D^v d starts, the first with q = L - v, contributes an error
// h^(1+q) at a fixed time and h^(L-a+q) at the first step, a the largest order of a term. A power t^q of g
// contributes h^(1+q) and h^(L-v+q). Both are integrated exactly for q = 0 and 1. So the row of the largest
// order a has the smallest rate, 1 + L - a, if g does not depend on fractional rows: these contain the
// derivative of T, t^(1-v). The Taylor part itself contributes no error, nor does the linear prediction of
// multi_term_pc.
double multi_term_trapezoidal_rate(const Problem& problem, const Smoothness& smoothness, double grading,
                                   Norm norm);

// A multistep rule with starting weights: as the trapezoidal rule, with the method's rate, and exact for the
// powers q of D^v d and g that have starting weights.
double multi_term_multistep_rate(const WeightFamily& family, const Problem& problem,
                                 const Smoothness& smoothness, double grading, Norm norm);

// Backward Euler convolution quadrature: h, and at the first step h^q where D^v d starts like t^q.
double multi_term_grunwald_letnikov_rate(const Problem& problem, const Smoothness& smoothness, double grading,
                                         Norm norm);

}  // namespace fde
