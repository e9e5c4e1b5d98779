// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// Progress of a sweep: it starts to examine or to time a run, a run is done, or the refinement has ended (no
// further run of this scene, scheme and grading follows).
struct SweepEvent {
  enum class Kind { examines, times, is_done, refinement_ends };
  Kind kind;
  RunKey run;
  bool with_reference = false;  // this examination also computes the reference of the scene
};

}  // namespace fde::bench
