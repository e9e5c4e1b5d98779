// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "fdebench/schemes/diagnostics/growing_mode_count.hpp"

namespace fde {

// The linear stability region of a scheme at one order g: the z = lambda h^g for which the scheme has no
// growing mode for D^g y = lambda y. The exact solution decays in the sector |arg z| > g pi/2 (Matignon
// 1996). With a delay of so many steps z is that of D^g y = lambda y(t - delay h). All functions throw
// std::invalid_argument as count_growing_modes does.

// The root locus: the z for which the symbol has a zero at zeta = e^(i theta). Precondition: 0 < theta <= pi.
// One z for an implicit rule, two for a predictor-corrector, each of which may be on the boundary: the
// determinant of the symbol is a polynomial of that degree in z, for split schemes too. The values at -theta
// are the conjugates. One z with a delay.
std::vector<ComplexValue> root_locus(const Scheme& scheme, double order, double theta, int delay = 0);

// The length of the real stability interval: the largest x such that z = -x' is stable for all 0 < x' < x;
// infinity when all are.
double real_stability_interval(const Scheme& scheme, double order, int delay = 0);

// That of the equation D^g y = lambda y(t - delay) in -lambda, 0 < g < 2: a mode s = iw has the phase
// g pi/2 + w delay = pi, hence (pi (1 - g/2) / delay)^g (at g = 1 Hayes 1950; Krol 2011; Cermak, Hornicek &
// Kisela, Commun. Nonlinear Sci. Numer. Simul. 31 (2016)).
double real_stability_interval(double order, double delay);

// The largest angle phi, in radians, such that all z with |arg(-z)| < phi are stable: A(phi)-stability. For
// the exact equation it is pi - g pi/2. 0 when the real interval is finite.
double stability_angle(const Scheme& scheme, double order);

// The stiff limit y_n / y_0, n = 0 ... steps, for z -> -infinity with fixed h, y'(0) = 0 for orders above 1;
// it is 0 where an infinitely fast transient is damped completely, infinity from where y_n overflows. nullopt
// for a predictor-corrector, which has no limit.
std::optional<Vec> stiff_limit(const Scheme& scheme, double order, int steps);

// A point z in the upper half plane of the boundary of a stability region: for this z the symbol has a zero
// at zeta = exp(i theta) or, for the conjugate of z, at exp(-i theta).
struct BoundaryPoint {
  double theta;
  ComplexValue z;
};

// The boundary of the stability region of a scheme at one order: the parts of the root locus curve (where a
// mode is on the unit circle) across which stability changes. Each piece is a polyline in the order of its
// points; a whole curve has points + 1 points, denser at both ends. Throws as count_growing_modes does.
std::vector<std::vector<BoundaryPoint>> region_boundary(const Scheme& scheme, double order, int points);

// The root that is closest to z: it continues the boundary curve through z. Precondition: roots is not empty.
inline ComplexValue nearest_root(const std::vector<ComplexValue>& roots, ComplexValue z) {
  return std::ranges::min(roots, {}, [&](ComplexValue root) { return std::abs(root - z); });
}

// A vector of length part * |z|, normal to the boundary curve at its point z of the angle theta.
inline ComplexValue boundary_normal(const Scheme& scheme, double order, double theta, ComplexValue z,
                                    double part) {
  const ComplexValue along = nearest_root(root_locus(scheme, order, 0.999 * theta), z) - z;
  return ComplexValue(0.0, part * std::abs(z)) * along / std::abs(along);
}

}  // namespace fde
