// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sweep_plan.hpp"

#include <algorithm>
#include <array>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/records/counted_error.hpp"

namespace fde::bench {
namespace {

constexpr std::array hopeless{
    OutcomeKind(SolveStatus::refused),       OutcomeKind(SolveStatus::left_domain),
    OutcomeKind(SolveStatus::out_of_budget), OutcomeKind(Verdict::no_reference),
    OutcomeKind(Verdict::overflow),          OutcomeKind(Verdict::passed_singularity),
    OutcomeKind(Verdict::program_failed)};

// With the bound of the reference: a run is within an accuracy with both.
RunError error_of(const Record& run, Norm norm) {
  const ErrorKind kind{.norm = norm, .scale = Scale::mixed};
  RunError error;
  const auto counted = counted_error(run, kind);
  if (!counted) return error;
  error.value = counted->value + counted->reference_bound;
  error.baseline = run[baseline_measure(kind)].value_or(error.baseline);
  error.is_stagnant =
      counted->value <= counted->reference_bound || (norm == Norm::end && run["rounding_from"]);
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
