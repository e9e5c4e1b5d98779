// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "fdebench/schemes/diagnostics/other_steps.hpp"

namespace fde {

// Whether the trapezoidal rule, which damps no oscillation of the equation, leaves on the same grid more than
// twice as much of a component as the run does, where the run may have damped one (may_damp_oscillation), as
// half a sentence. Without such an oscillation the trapezoidal rule may keep a stiff mode that the equation
// damps.
std::optional<std::string> damped_oscillation(const SolvedRun& run);

}  // namespace fde
