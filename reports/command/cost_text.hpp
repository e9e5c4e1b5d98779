#pragma once

#include <string>

#include "command/asked_run.hpp"
#include "command/checkpoint_file.hpp"

namespace fde {

// The cost of a run as one JSON object; docs/command.md lists the keys. Counts that are unknown are left out,
// and the grid unless graded:auto chose it. `checkpoints` may be nullptr.
std::string cost_text(const Scene& scene, const AskedRun& run, const Cost& cost, double seconds,
                      const CheckpointFile* checkpoints);

}  // namespace fde
