// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/reports/command/checkpoint_file.hpp"
#include "fdebench/reports/command/requested_run.hpp"

namespace fde::bench {

// The cost of a run as one JSON object; docs/command.md lists the keys. Counts that are unknown are left out,
// and the grid unless graded:auto chose it. `checkpoints` may be nullptr.
std::string cost_text(const Scene& scene, const RequestedRun& run, const Cost& cost, double seconds,
                      const CheckpointFile* checkpoints);

}  // namespace fde::bench
