#pragma once

#include "stepping/scheme.hpp"
#include "weights/family.hpp"

namespace fde {

// The rates of the integrated equations (integrated_equations.hpp), of the rows D^v u that are looked at.
//
// Trapezoidal rule: h^2. D^v d, which leaves 0 like t^q, q = L - v first, costs h^(1+q) at a fixed time and
// h^(L-a+q) at the first step, a the largest order of a term; g, which starts like t^q, costs h^(1+q) and
// h^(L-v+q); both are exact for q = 0 and 1. So the row of the largest order a costs 1 + L - a, the least of
// all, where g does not read fractional rows: these hold what T leaves of D^v u, t^(1-v). The Taylor part
// itself costs nothing. The prediction of multi_term_pc, a line, costs nothing either.
double multi_term_trapezoidal_rate(const Problem& problem, const Smoothness& smoothness, double grading,
                                   Norm norm);

// A multistep rule with start weights: as the trapezoidal rule, with the method's rate, and exact for the
// powers q of D^v d and g that have start weights.
double multi_term_multistep_rate(const WeightFamily& family, const Problem& problem,
                                 const Smoothness& smoothness, double grading, Norm norm);

// Backward Euler convolution quadrature: h, and at the first step h^q of D^v d.
double multi_term_grunwald_letnikov_rate(const Problem& problem, const Smoothness& smoothness, double grading,
                                         Norm norm);

}  // namespace fde
