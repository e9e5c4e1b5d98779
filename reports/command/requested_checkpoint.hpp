// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "fdebench/benchmarks/observers/retained_columns.hpp"
#include "fdebench/reports/command/checkpoint_file.hpp"
#include "fdebench/reports/command/requested_run.hpp"

namespace fde::bench {

// The file of --checkpoint, with the columns `kept` as part of the state; nullopt without --checkpoint. `say`
// is called with a message if the file cannot be written. The file is valid for runs with the same scene,
// scheme, resolution, history, tolerance and times by the same build. Throws std::invalid_argument naming the
// argument, the text and what is allowed.
std::optional<CheckpointFile> requested_checkpoint(const Scene& scene, const RequestedRun& run,
                                                   const RunArguments& arguments, RetainedColumns& kept,
                                                   const std::function<void(const std::string&)>& say);

}  // namespace fde::bench
