#pragma once

#include <string>
#include <vector>

#include "fdebench/schemes/diagnostics/other_steps.hpp"

namespace fde {

// Why the numbers of a run deserve distrust. Told by the problem and by runs of the scheme alone, without a
// reference.
enum class Doubt {
  feature,      // a step is longer than the time between two jumps of the right-hand side
  stability,    // modes of the scheme grow that are none of the equation
  growth,       // the run grows where the equation does not
  alternation,  // the last steps go up and down
  oscillation,  // the run has lost an oscillation of the equation
  other_steps,  // another number of steps gives other values
};

struct Warning {
  Doubt doubt;
  std::string text;  // half a sentence
};

// None where nothing is found, which is no proof. Whether there is any is mostly asked of other numbers of
// steps: a few percent of the time of a long run, less than a millisecond of a short one, up to about the
// time of the run where they leave a doubt. With check, the run is also compared with one of half the steps.
// Precondition: the run has finished, and has stored all times or those of with_times_looked_at.
std::vector<Warning> warnings(const SolvedRun& run, bool check = false);

// The times asked of a run and those that warnings() looks at; none: all are stored anyway.
std::vector<double> with_times_looked_at(const Problem& problem, const Grid& grid, std::vector<double> times);

}  // namespace fde
