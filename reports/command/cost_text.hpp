#pragma once

#include <string>

#include "command/asked_run.hpp"
#include "command/checkpoint_file.hpp"

namespace fde {

// What a run took, as one JSON object: docs/command.md lists its keys. What was not counted or is not known
// is left out, and the grid where it was named.
std::string cost_text(const Scene& scene, const AskedRun& run, const Cost& cost, double seconds,
                      const CheckpointFile* checkpoints);

}  // namespace fde
