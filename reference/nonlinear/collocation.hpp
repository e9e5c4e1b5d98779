#pragma once

#include "nonlinear/panel_table.hpp"

namespace fde {

// Reference solution of a nonlinear multi-order system by piecewise collocation: independent of every scheme.
// On each panel of a mesh graded towards t = 0, f(t, y(t)) is a polynomial through Gauss points, and
//   y_i(t) = Taylor part + 1/Gamma(gamma_i) int_0^t (t-s)^(gamma_i-1) f_i(s) ds
// holds at them, with Gauss-Radau points where there are algebraic rows. The error estimate comes from a
// second resolution, other panels and another degree, and from a second method, diffusive_solution, which has
// neither panels nor the integral; see error_estimates.
struct CollocationOptions {
  double tolerance = 1e-13;  // relative, asked of the panel resolution; rounding allows about 1e-14
};

// Orders are in [0, 2], those of algebraic rows 0; f is continuous but for what unknowns of algebraic rows
// add and at problem.jumps, and smooth for other t > 0. ReferenceValue::bound is an estimate. Throws
// std::runtime_error naming the method and the time where one of the two does not converge, the order that is
// too small for a problem with algebraic rows, or how many unknowns are more than 200: without a second
// opinion there is no reference. Throws std::invalid_argument for a problem it cannot pose or, from
// Reference::at, a time outside [0, problem.end].
Reference reference_solution(const Problem& problem, const CollocationOptions& options = {});

// The same as a table to be kept, and the reference that it makes. Initial values are exact; those of
// algebraic rows that their rows do not hold at t = 0 are guesses, of which nothing is known: their bound is
// infinite there.
PanelTable reference_table(const Problem& problem, const CollocationOptions& options = {});
Reference table_reference(PanelTable table, const Problem& problem);

}  // namespace fde
