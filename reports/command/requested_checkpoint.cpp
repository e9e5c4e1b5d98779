// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/requested_checkpoint.hpp"

#include <fmt/format.h>

#include <chrono>

#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/schemes/history/block_kernels.hpp"

namespace fde::bench {
namespace {

// The option that selects the output times.
std::string times_text(const RunArguments& arguments) {
  if (arguments.at) return "--at " + *arguments.at;
  if (arguments.every) return "--every " + *arguments.every;
  return arguments.points ? "--points " + *arguments.points : "all";
}

RunFacts facts_of(const Scene& scene, const RequestedRun& run, const RunArguments& arguments) {
  const Session session = this_session();
  return {{"program",
           fmt::format("{} {} {} {}", session.version, session.commit, session.compiler, session.flags)},
          {"instructions", std::string(vector_targets().front())},
          {"scene", scene.name},
          {"end", fmt::format("{}", scene.problem.end)},
          {"scheme", std::string(run.scheme.id)},
          {"steps", resolution_text(run.setup)},
          {"grid", grid_text(run.setup.grading)},
          {"history", std::string(name(run.setup.history))},
          {"tolerance", fmt::format("{}", run.setup.tolerance)},
          {"times", times_text(arguments)}};
}

}  // namespace

std::optional<CheckpointFile> requested_checkpoint(const Scene& scene, const RequestedRun& run,
                                                   const RunArguments& arguments, RetainedColumns& kept,
                                                   const std::function<void(const std::string&)>& say) {
  if (!arguments.checkpoint) {
    if (arguments.checkpoint_every)
      reject_text("--checkpoint-every", *arguments.checkpoint_every, "with --checkpoint");
    return std::nullopt;
  }
  const double between = arguments.checkpoint_every
                             ? parse_number("--checkpoint-every", *arguments.checkpoint_every, not_negative)
                             : usual_seconds_between_checkpoints;
  if (const auto reason = unsupported_checkpoints_reason(run.scheme, scene.problem)) {
    reject_text("--checkpoint", *arguments.checkpoint,
                fmt::format("left out: {} {}", run.scheme.id, *reason));
  }
  return std::optional<CheckpointFile>(
      std::in_place, *arguments.checkpoint, std::chrono::duration<double>(between),
      facts_of(scene, run, arguments), [&kept](Archive& archive) { archive(kept); }, say);
}

}  // namespace fde::bench
