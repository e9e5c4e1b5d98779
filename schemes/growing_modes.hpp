#pragma once

#include <optional>

#include "scheme.hpp"

namespace fde {

// How many modes of the scheme grow on the problem D^(g_i) y_i = (A y)_i, A its linear_part, with steps of
// this length and one correction: the zeros of det M(zeta) in |zeta| < 1, counted by the argument principle,
// each as often as its multiplicity. nullopt: one stands on the unit circle, to rounding.
//
// M is singular at zeta = 1, so the path passes it inside at |log zeta| = 10^(-6/g), g the smallest order, at
// most 1e-12 and at least 1e-300. Slower modes are not counted: those of the exact equation for rates lambda
// with |lambda h^g| < 1e-6.
//
// Throws std::invalid_argument when the problem has no linear_part, an algebraic row or a right derivative,
// or the scheme refuses it or has no symbol.
std::optional<int> growing_modes(const Scheme& scheme, const Problem& problem, double length);

// Whether there is none.
bool stable(const Scheme& scheme, const Problem& problem, double length);

// The largest h up to `longest` such that all shorter ones from `shortest` on are stable, on a grid of steps
// 5 % apart, then bisected to nine digits; 0: not even the shortest is.
double largest_stable_step(const Scheme& scheme, const Problem& problem, double shortest, double longest);

// The symbol that is looked at; throws as above.
Symbol symbol_of(const Scheme& scheme, const Problem& problem, double length);

// D^order y = rate y from y(0) = 1 as a problem: of one component, or of real and imaginary part for a
// complex rate, whose modes then are those of the rate and of its conjugate.
Problem scalar_equation(double order, ComplexValue rate, double end = 1.0);

}  // namespace fde
