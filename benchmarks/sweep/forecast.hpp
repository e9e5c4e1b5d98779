// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/benchmarks/sweep/sweep.hpp"

namespace fde::bench {

// The expected seconds of a run: to examine it, and to time it.
struct ExpectedSeconds {
  double examination = 0.0, timing = 0.0;
  std::string refusal{};  // why the scheme refuses the run; empty: it does not

  [[nodiscard]] double total() const { return examination + timing; }
};

// The runs that a sweep is expected to make.
using Forecast = std::map<RunKey, ExpectedSeconds>;

double total_seconds(const Forecast& forecast);

// Predicts which runs the sweep will make, and their seconds. Three solves with few steps measure the time of
// a step and the error of each scheme on each scene that choose_probes() chooses; the refinement of every
// scene is then simulated as the sweep does it. Runs for which `recorded` returns all measures are not
// forecast. Without a goal the runs are exactly those of the sweep; the seconds, those of references
// included, are a rough estimate.
Forecast forecast(const Sweep& sweep, const RecordedLookup& recorded);

}  // namespace fde::bench
