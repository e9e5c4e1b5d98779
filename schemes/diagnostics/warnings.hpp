// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

struct SolvedRun;

// What speaks against the numbers of a run, found from the problem and from runs of the scheme alone, without
// a reference.
enum class Finding {
  feature,      // a step is longer than the time between two jumps of the right-hand side
  stability,    // modes of the scheme grow that are none of the equation
  growth,       // the run grows where the equation does not
  alternation,  // the last steps go up and down
  oscillation,  // the run has lost an oscillation of the equation
  other_steps,  // another number of steps gives other values
  accuracy,     // a run with a tolerance does not keep it
  drift,        // a constraint is not fulfilled
  event,        // an event is not located
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

// Where the error of a run exceeds its tolerance: by so many times rtol |y| + atol.
struct MissedAccuracy {
  double times;
  Eigen::Index row, column;
};

// The values that the same scheme gives for the same problem with another tolerance, in the same rows and
// columns; empty: it does not come to the end.
using OtherRun = std::function<std::optional<Rows>(const Tolerance&)>;

// Compares values of a run with those of a run with ten times its tolerance. If errors are proportional to
// the tolerance, the difference is nine times the error of the run; where that does not decide, or with
// check, a run with a tenth of the tolerance does, whose difference is nine tenths of it. Empty: within five
// times the tolerance, as far as these runs show. Values that are not finite are left out.
std::optional<MissedAccuracy> missed_accuracy(const Tolerance& requested, const Rows& values,
                                              const OtherRun& other, bool check = false);

}  // namespace fde
