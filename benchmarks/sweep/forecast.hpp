// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/benchmarks/sweep/sweep.hpp"

namespace fde::bench {

double total_seconds(const Forecast& forecast);

// Predicts which runs the sweep will make, and their seconds. Three solves with few steps measure the time of
// a step and the error of each scheme on each scene that choose_probes() chooses; the refinement of every
// scene is then simulated as the sweep does it. Runs for which `recorded` returns all measures are not
// forecast. Without a goal the runs are exactly those of the sweep; the seconds, those of references
// included, are a rough estimate.
Forecast forecast(const Sweep& sweep, const RecordedLookup& recorded);

}  // namespace fde::bench
