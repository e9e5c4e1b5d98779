#pragma once

#include <functional>
#include <optional>
#include <string>

#include "command/asked_run.hpp"
#include "command/checkpoint_file.hpp"
#include "observers/kept_columns.hpp"

namespace fde {

// The file of --checkpoint, which keeps the columns too, and says what it cannot write; nullopt: none was
// asked for. It belongs to runs of this scene, scheme, resolution, history, tolerance and times by this
// program. Throws std::invalid_argument naming the argument, the text and what is allowed.
std::optional<CheckpointFile> asked_checkpoint(const Scene& scene, const AskedRun& run,
                                               const RunArguments& arguments, KeptColumns& kept,
                                               const std::function<void(const std::string&)>& say);

}  // namespace fde
