// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/schemes/history/weights/polylogarithm.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// The number of growing modes of the scheme for D^(g_i) y_i = (A y + sum_k B_k y(t - lag_k))_i, the linear
// part of the problem, with this step size and one correction: the zeros of det S(zeta) in |zeta| < 1,
// counted with multiplicity by the argument principle. nullopt: a zero is on the unit circle, to rounding.
//
// The argument of det S is followed along the contour in pieces on which det S changes by less than half
// between its end points and its middle. The count is therefore not a proof. With delays the pieces resolve
// the powers zeta^m, unless the earlier values are a small part of det S, whatever their phases.
//
// S is singular at zeta = 1, so the contour passes inside of it at |log zeta| = 10^(-6/g), g the smallest
// order, at most 1e-12 and at least 1e-300. Slower modes are not counted: modes of the exact equation for
// lambda with |lambda h^g| below 1e-6, or 1e-300^g for orders below 0.02, such as 1e-3 at order 0.01.
//
// Throws std::invalid_argument when the problem has no linear part, has an algebraic row or a right
// derivative, or the scheme refuses it or has no symbol, or a delay below four steps is no whole number of
// them (rules evaluate f twice, from different polynomials then); std::runtime_error when an entry of S
// overflows, or delays would take more than a million pieces. Precondition: f is linear in earlier values.
std::optional<int> count_growing_modes(const Scheme& scheme, const Problem& problem, double length);

// The number of growing modes e^(st) of the equation itself: the zeros of
//   det(diag s^(g_i) - A - sum_k B_k e^(-s lag_k))
// with |arg s| < pi/2 - 1e-9, counted in the same way; modes slower than |s| length = |log zeta| above are
// left out. Without delays a mode of D^g y = lambda y grows for |arg lambda| < g pi/2 (Matignon 1996). Throws
// as above where the problem has no linear part, an algebraic row or a right derivative.
std::optional<int> count_growing_modes(const Problem& problem, double length);

// Whether count_growing_modes is 0. Throws as count_growing_modes does.
bool is_linearly_stable(const Scheme& scheme, const Problem& problem, double length);

// The largest step size h <= longest such that all tested step sizes from `shortest` to h are stable: a
// geometric sequence with the ratio 1.05, then bisection to nine digits. 0 where `shortest` is not stable.
// Throws as count_growing_modes does.
double largest_stable_step(const Scheme& scheme, const Problem& problem, double shortest, double longest);

// The test equation D^order y = rate y, y(0) = 1, y'(0) = 0, as a row, or in multi-term form where the scheme
// discretises equations. With a delay above 0 it is D^order y = rate y(t - delay), y = 1 before, for a real
// rate.
Problem test_problem(const Scheme& scheme, double order, ComplexValue rate, double end = 1.0,
                     double delay = 0.0);

// The symbol S of the scheme for this problem and step size. Throws std::invalid_argument as
// count_growing_modes does.
Symbol symbol_of(const Scheme& scheme, const Problem& problem, double length);

}  // namespace fde
