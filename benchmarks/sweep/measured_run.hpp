// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "fdebench/benchmarks/measures/own_measure.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// The key of a scheme's run of a scene in results. A scheme of the caller is external: no command has it.
RunKey key_of(const Scheme& scheme, const SceneSettings& scene, const RunSettings& settings);

// The record of one run except its times: solves once within the budget and compares the run with the
// reference at comparison_times. `name` is the scene's key in the record. Thread safe if each thread has its
// own MemoizedReference.
Record examine(const SceneSettings& name, const Scene& scene, MemoizedReference& reference,
               const Scheme& scheme, const RunSettings& settings, std::span<const OwnMeasure> own = {});

// The number of timed repeats of a run: `most`; more while they take less than `min_seconds` in total, no
// more once they have taken `enough_seconds`. Where other work disturbs them, all are repeated, `attempts`
// times in total at most.
struct TimingRepeats {
  int most = 3;
  double min_seconds = 0.01, enough_seconds = 10.0;
  int attempts = 1;
};

// The times of a run; of several attempts the last. The solves store the last step only. Preconditions:
// is_compared(ending) of the run, and no other work on the machine during the call.
Timing time_solves(const Scene& scene, const Scheme& scheme, const RunSettings& settings,
                   const TimingRepeats& repeats);

}  // namespace fde::bench
