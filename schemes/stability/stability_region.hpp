#pragma once

#include <optional>
#include <vector>

#include "stability/growing_modes.hpp"

namespace fde {

// The region of linear stability of a scheme at one order g: the z = lambda h^g for which D^g y = lambda y
// has no growing mode. The exact equation decays in the sector |arg z| > g pi/2 (Matignon 1996). All throw
// std::invalid_argument as growing_modes does.

// Where a mode stands at zeta = e^(i theta), 0 < theta <= pi: one z for an implicit rule, two, either of
// which may be a boundary, for one with a prediction (the determinant of the symbol is a polynomial of
// that degree in z, for split schemes too). The values at -theta are the conjugates.
std::vector<ComplexValue> boundary(const Scheme& scheme, double order, double theta);

// The largest x such that -x' is stable for all 0 < x' < x; infinity when all are.
double real_interval(const Scheme& scheme, double order);

// The largest angle phi, in radians, such that all z with |arg(-z)| < phi are stable: A(phi)-stability. Of
// the exact equation it is pi - g pi/2. 0 when the real interval is finite.
double stability_angle(const Scheme& scheme, double order);

// y_n / y_0 in the limit z -> -infinity, n = 0 ... steps, with h fixed: what is left of a transient that is
// infinitely fast; infinity from where it is beyond double. nullopt: a scheme with a prediction, which has no
// limit. y'(0) = 0 for orders above 1.
std::optional<Vec> response_at_infinity(const Scheme& scheme, double order, int steps);

}  // namespace fde
