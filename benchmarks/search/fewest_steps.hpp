#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fdebench/benchmarks/search/candidate_run.hpp"

namespace fde {

// The run with about the fewest steps (to 1.5 %) whose error is within the accuracy; `attempt` makes a run.
// Precondition: of `ladder`, runs with doubled steps, only the last is within the accuracy. Numbers of steps
// are multiples of `unit`. With `scan` the steps are also decreased by a factor of 1.05 down to a sixteenth,
// and sign changes of the error in between are searched: an error that passes through 0 is small there.
Attempt fewest_steps(const std::vector<Attempt>& ladder, double accuracy, int unit, bool scan,
                     const std::function<Attempt(int steps)>& attempt);

// Bisects for a run within the accuracy between two runs whose errors at the end have opposite signs. nullopt
// if no number of steps in between has a small error, or a run in between fails.
std::optional<Attempt> at_sign_change(Attempt few, Attempt many, int unit,
                                      const std::function<Attempt(int steps)>& attempt);

// About 1 % more steps, a multiple of `unit`.
int more_steps(int steps, int unit);

}  // namespace fde
