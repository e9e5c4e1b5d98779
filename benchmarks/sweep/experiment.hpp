#pragma once

#include <limits>
#include <vector>

#include "references/watched_reference.hpp"
#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"
#include "sweep/ending.hpp"
#include "sweep/record.hpp"

namespace fde {

// Everything of one (scene, scheme, steps) of a sweep but its time: solves once within the budget (seconds),
// compares with the reference at watched_times and takes every measure that applies; the rows carry the label
// as their scene. The last row is the outcome; a run that is refused or stops early has this one only.
// Without a reference the outcome says why, and the measures that need none are there all the same. May go on
// side by side, each scene with a WatchedReference of its own.
std::vector<Record> examine(const std::string& label, const Scene& scene, WatchedReference& reference,
                            const Scheme& scheme, int steps,
                            double budget = std::numeric_limits<double>::infinity());

// The time rows of a run that is_compared: solves `repeats` times, more where that takes less than 20 ms, no
// more once it has taken 10 s, storing the last step only. The last row has the status "timed". To be called
// while nothing else runs.
std::vector<Record> time_solves(const std::string& label, const Scene& scene, const Scheme& scheme, int steps,
                                int repeats);

}  // namespace fde
