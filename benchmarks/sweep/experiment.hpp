#pragma once

#include <vector>

#include "records/record.hpp"
#include "references/watched_reference.hpp"
#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// Everything of one run but its time: solves once within the budget, judges the run at watched_times by the
// reference, and makes a row of every measure and the last one of the ending. The name is that of the scene
// in the rows. May go on side by side, each scene with a WatchedReference of its own.
std::vector<Record> examine(const SceneSettings& name, const Scene& scene, WatchedReference& reference,
                            const Scheme& scheme, const Setup& setup);

// How often a run is timed: `most` times, more where that takes less than the least seconds, no more once it
// has taken enough of them.
struct Repeats {
  int most = 3;
  double least_seconds = 0.01, enough_seconds = 10.0;
};

// The time rows of a run that is_compared, storing the last step only. To be called while nothing else runs.
std::vector<Record> time_solves(const SceneSettings& name, const Scene& scene, const Scheme& scheme,
                                const Setup& setup, const Repeats& repeats);

}  // namespace fde
