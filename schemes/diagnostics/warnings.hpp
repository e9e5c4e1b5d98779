// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/schemes/diagnostics/other_steps.hpp"

namespace fde {

// What speaks against the numbers of a run, found from the problem and from runs of the scheme alone, without
// a reference.
enum class Finding {
  feature,      // a step is longer than the time between two jumps of the right-hand side
  stability,    // modes of the scheme grow that are none of the equation
  growth,       // the run grows where the equation does not
  alternation,  // the last steps go up and down
  oscillation,  // the run has lost an oscillation of the equation
  other_steps,  // another number of steps gives other values
};

struct Warning {
  Finding finding;
  std::string text;  // half a sentence
};

// Empty where nothing is found, which is no proof. Most findings come from runs with other numbers of steps:
// they take a few percent of the time of a long run, less than a millisecond for a short one, and up to about
// the time of the run where they do not decide. With check, the run is also compared with one of half the
// steps. Precondition: the run has finished, and has stored all times or those of with_times_looked_at.
std::vector<Warning> warnings(const SolvedRun& run, bool check = false);

// The output times of a run and those that warnings() looks at; none: all are stored anyway.
std::vector<double> with_times_looked_at(const Problem& problem, const Grid& grid, std::vector<double> times);

}  // namespace fde
