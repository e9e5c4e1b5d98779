#pragma once

#include <vector>

#include "measures/ending.hpp"
#include "measures/measures.hpp"
#include "references/watched_reference.hpp"
#include "scenes/scene.hpp"

namespace fde {

// What is said of a run: how it ended and at what time, and every measure that applies.
struct Judgement {
  RunEnding ending{};
  double until = 0.0;  // where it stopped or lost its accuracy; otherwise the end
  std::vector<Measured> measured{};
};

// Judges a trajectory of the scene, with one time at least, by the scene's reference. A run that stopped has
// no measures, nor has one beside a reference that is not finite, or of which a measure is not finite.
// Without a reference there are those that need none.
Judgement judge(const Scene& scene, const Trajectory& path, WatchedReference& reference,
                const Observed& observed = {});

// The same of a run whose columns at path.times, one column a time, stand for the states.
Judgement judge(const Scene& scene, const Trajectory& path, const Rows& columns, WatchedReference& reference,
                const Observed& observed);

// The same for the columns of the scene at some times, one column a time: what another program writes. They
// have come to their end.
Judgement judge_columns(const std::vector<double>& times, const Rows& columns, WatchedReference& reference,
                        const Observed& observed = {});

}  // namespace fde
