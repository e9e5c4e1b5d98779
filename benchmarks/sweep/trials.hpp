// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fdebench/benchmarks/sweep/sweep.hpp"

namespace fde::bench {

// A scene on which schemes fail, with a number of steps. Schemes with adaptive step size get trial_accuracy.
struct Trial {
  std::string kind;  // a heading: "Stiff", "Extreme orders", ...
  SceneVariant scene;
  int steps;
  bool thorough = false;  // takes too long for the default sweep
};

// Relative and absolute tolerance of the trials with adaptive step size.
inline constexpr Tolerance trial_accuracy{1e-6, 1e-300};

// All trials, each scene once; trials of one kind are adjacent.
std::span<const Trial> trials();

// The trials as sweeps with the schemes and settings of `like`, one sweep per number of steps. Trials with
// `thorough` are included on request. In place of a search, whose times are compared, each run is timed once.
std::vector<Sweep> sweeps_of_trials(Sweep like, bool thorough);

}  // namespace fde::bench
