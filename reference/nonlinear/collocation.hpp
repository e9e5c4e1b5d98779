// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/nonlinear/panel_table.hpp"

namespace fde::reference {

// Reference solution of a nonlinear multi-order system by piecewise collocation, independent of every scheme.
// On each panel of a mesh graded towards t = 0, f(t, y(t)) is a polynomial through Gauss points, and
//   y_i(t) = Taylor part + 1/Gamma(gamma_i) int_0^t (t-s)^(gamma_i-1) f_i(s) ds
// holds at them, with Gauss-Radau points where there are algebraic rows. The error estimate comes from a
// second resolution, other panels and another degree, and from a second method, diffusive_solution, which has
// neither panels nor the integral; see error_estimates.
struct CollocationOptions {
  double tolerance = 1e-13;  // relative, of the resolution of the panels; rounding limits it to about 1e-14
};

// Orders are in [0, 2], those of algebraic rows 0; f is continuous except at problem.jump_times and for terms
// with unknowns of algebraic rows, and smooth for other t > 0. ReferenceValue::bound is an estimate. Throws
// std::runtime_error if one of the two methods does not converge (naming the method and the time), if an
// order is too small for a problem with algebraic rows, or if there are more than 200 unknowns. With
// conditions at both ends each method finds the unknown initial values by its own runs (shooting.hpp);
// std::runtime_error is thrown also where one finds none, or others than the method before.
//
// Each run finds the events that set unknowns (Problem::resets) by itself, and y is as before up to the time
// of one. Where the runs do not tell whether an event has been passed the bound contains the jump of y:
// within some rounding errors of its time, unless that depends on t alone. std::runtime_error is thrown where
// the runs find different events. Throws
// std::invalid_argument for a problem that require_supported() rejects and, from Reference::at, for a time
// outside [0, problem.end].
Reference reference_solution(const Problem& problem, const CollocationOptions& options = {});

// The same as a table that can be stored, and the Reference of a table, which throws std::runtime_error where
// a bound is more than a hundred times the largest value: then nothing is known. At t = 0 the bound is 0
// where the initial values are exact, and infinite where they are guesses: for multipliers, or for the
// unknowns of all algebraic rows if these rows do not hold at t = 0.
PanelTable reference_table(const Problem& problem, const CollocationOptions& options = {});
Reference reference_from_table(PanelTable table, const Problem& problem);

}  // namespace fde::reference
