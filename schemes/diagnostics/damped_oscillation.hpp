// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "fdebench/schemes/diagnostics/other_steps.hpp"

namespace fde {

// Whether the trapezoidal rule, which damps no oscillation of the equation, leaves on the same grid more than
// twice as much of a component as the run does, as half a sentence. Asked of runs that are not long, where
// they may have damped one: may_damp_oscillation, and all with algebraic rows, whose modes are not known.
std::optional<std::string> damped_oscillation(const SolvedRun& run);

}  // namespace fde
