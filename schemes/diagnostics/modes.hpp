// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "fdebench/schemes/diagnostics/other_steps.hpp"

namespace fde {

// What the linear part of a problem, its Jacobian frozen at a few states of a run, says of that run. Except
// by may_damp_oscillation nothing is said of problems with algebraic rows, by unstable_modes alone something
// of those with delays, and nothing of problems at both ends.

// Whether the scheme has modes with this length of a step that grow where those of the equation do not, as
// half a sentence. Where all orders are equal the eigenvalues are looked at, the largest of them; otherwise,
// and with delays, the modes of the whole linear part are counted, those of the scheme and of the equation.
std::optional<std::string> unstable_modes(const SolvedRun& run);

// Whether the equation has no growing mode at these states and the run grew to a thousand times what its
// initial values and its load make: |Taylor part| + t^g / Gamma(g+1) |f(., y(0))|.
std::optional<std::string> growth_of_its_own(const SolvedRun& run);

// Whether the modes are eigenvalues: all orders are equal and no row is algebraic.
bool has_eigenvalue_modes(const Problem& problem);

// Whether the equation has an oscillation of which a tenth is left at the end or more, and which backward
// Euler's method with these steps damps by a tenth or more. Where the modes are not eigenvalues they are
// counted by the argument principle; true also where that cannot be decided.
bool may_damp_oscillation(const SolvedRun& run);

// Whether the equation has an oscillation, at t = 0, that leaves ten times more of the initial values than is
// left of the run, with steps with which backward Euler's method damps it.
std::optional<std::string> lost_oscillation(const SolvedRun& run);

}  // namespace fde
