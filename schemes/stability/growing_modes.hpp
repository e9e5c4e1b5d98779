#pragma once

#include <optional>

#include "stepping/scheme.hpp"

namespace fde {

// How many modes of the scheme grow on the problem D^(g_i) y_i = (A y)_i, A its linear part, with steps of
// this length and one correction: the zeros of det S(zeta) in |zeta| < 1, counted by the argument principle,
// each as often as its multiplicity. nullopt: one stands on the unit circle, to rounding.
//
// The contour is sampled, in pieces over which, end points and middle, det S changes by less than half. So
// the count is no proof.
//
// S is singular at zeta = 1, so the path passes it inside at |log zeta| = 10^(-6/g), g the smallest order, at
// most 1e-12 and at least 1e-300. Slower modes are not counted: those of the exact equation for rates lambda
// with |lambda h^g| below 1e-6, or 1e-300^g for orders below 0.02, such as 1e-3 at order 0.01.
//
// Throws std::invalid_argument when the problem has no linear part, an algebraic row or a right derivative,
// or the scheme refuses it or has no symbol; std::runtime_error when an entry of S is beyond double.
std::optional<int> growing_modes(const Scheme& scheme, const Problem& problem, double length);

// Whether there is none.
bool stable(const Scheme& scheme, const Problem& problem, double length);

// The largest h up to `longest` such that all shorter ones from `shortest` on are stable, on a grid of steps
// 5 % apart, then bisected to nine digits; 0: not even the shortest is.
double largest_stable_step(const Scheme& scheme, const Problem& problem, double shortest, double longest);

// D^order y = rate y from y(0) = 1, y'(0) = 0 in the form that the scheme takes: as a row, or told as an
// equation.
Problem scalar_problem(const Scheme& scheme, double order, ComplexValue rate, double end = 1.0);

// The symbol that is looked at; throws as above.
Symbol symbol_of(const Scheme& scheme, const Problem& problem, double length);

}  // namespace fde
