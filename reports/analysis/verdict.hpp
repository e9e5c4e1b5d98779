#pragma once

#include <string>

#include "analysis/runs.hpp"

namespace fde {

// What became of a run. It survives when every value at the end is within a hundredth of its size of the
// reference, the bound of the reference included; it stops where the solution has a singularity.
enum class Verdict { survives, stops, inaccurate, fails, refuses, unknown };

Verdict verdict(const MeasuredRun& run);

// "survives"; the sentence that says why, with error, rounding and time where they were measured.
std::string name(Verdict verdict);
std::string because(const MeasuredRun& run);

}  // namespace fde
