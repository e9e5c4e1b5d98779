// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/nonlinear/collocation/piecewise_solution.hpp"

namespace fde::reference {

// The residual f(t, Y(t)) - F(t) of a collocation solution: Y is its piecewise polynomial for y, F the one
// that it takes for f. Both agree at the nodes, whatever f does between them, and on whatever root of the
// equations Newton's method has found.
//
// require_small_residual throws std::runtime_error naming the row and the time
// - if |residual| is above a millionth of the terms of f at a point, of three times as many on each panel as
//   there are nodes, and so large that it changes y by more than a millionth on the panel;
// - if interval arithmetic, on up to 4000 pieces of each panel, or, where f has terms that cancel, the
// residual at
//   the middles of these pieces does not show, on pieces that cover [0, end] without gaps, that it changes y
//   by no more than a twentieth on each panel: a pulse between the points, a transient that the first panel
//   passes over, or a solution that does not continue y(0) changes it by more. Without Problem::range this
//   part is left out.
// The first panel after a jump is left out of this: a row of small order may change there within the last
// digit of t. The root is followed over it instead (reference/nonlinear/march/implicit_step.hpp). Rows
// without a derivative are not examined, since F is no part of them.
void require_small_residual(const Problem& problem, const PiecewiseSolution& solution);

}  // namespace fde::reference
