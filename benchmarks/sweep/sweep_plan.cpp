// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sweep_plan.hpp"

#include <algorithm>
#include <array>

#include "fdebench/benchmarks/measures/error_kind.hpp"

namespace fde::bench {
namespace {

constexpr std::array hopeless{
    OutcomeKind(SolveStatus::refused),       OutcomeKind(SolveStatus::left_domain),
    OutcomeKind(SolveStatus::out_of_budget), OutcomeKind(Verdict::no_reference),
    OutcomeKind(Verdict::overflow),          OutcomeKind(Verdict::passed_singularity),
    OutcomeKind(Verdict::program_failed)};

RunError error_of(const Record& run, Norm norm) {
  const ErrorKind kind{.norm = norm, .scale = Scale::mixed};
  RunError error;
  error.value = run[error_measure(kind)].value_or(error.value);
  if (norm == Norm::maximum && run[error_measure(kind)])
    error.value = std::max(error.value, run[unresolved_measure(kind.scale)].value_or(0.0));
  error.baseline = run[baseline_measure(kind)].value_or(error.baseline);
  const bool at_end = norm == Norm::end;
  const auto absolute = run[at_end ? "error_end" : "error_maximum"],
             bound = run[at_end ? "reference_bound" : "reference_bound_maximum"];
  error.is_stagnant = (absolute && *absolute <= bound.value_or(0.0)) || (at_end && run["rounding_from"]);
  return error;
}

}  // namespace

std::vector<StepsOrTolerance> resolutions_for(const SweepPlan& plan, const Capabilities& capabilities) {
  std::vector<StepsOrTolerance> own;
  for (const auto& resolution : plan.resolutions) {
    const bool takes = std::holds_alternative<int>(resolution) != capabilities.is_adaptive();
    if (takes) own.push_back(resolution);
  }
  return own.empty() ? plan.resolutions : own;
}

RefinementRun refinement_run(const Record& run) {
  const auto& resolution = run.key.settings.resolution;
  const auto* steps = std::get_if<int>(&resolution);
  return {.resolution = resolution,
          .steps = steps != nullptr ? *steps : 0,
          .seconds = run["time_minimum"],
          .is_whole_process = run.timing.wall_clock,
          .fails_with_more_steps = std::ranges::find(hopeless, run.ending.kind) != hopeless.end(),
          .ending = run.ending,
          .errors = {error_of(run, Norm::end), error_of(run, Norm::maximum)}};
}

}  // namespace fde::bench
