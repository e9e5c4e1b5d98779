// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/search_outcome.hpp"

#include <algorithm>
#include <cmath>

namespace fde::bench {
namespace {

// Why no run is within the target.
SearchOutcome outcome_outside(const Refinement& refinement, const ErrorTarget& target, double quickest,
                              bool has_time) {
  const RefinementRun& finest = *refinement.finest();
  if (finest.ending.kind == SolveStatus::out_of_budget) return SearchOutcome::out_of_time;
  if (finest.ending.kind != SolveStatus::finished) return SearchOutcome::failed;
  if (*finest.seconds > quickest) return SearchOutcome::slower;
  if (has_stagnated(refinement, target.kind) || refinement.is_adaptive) return SearchOutcome::stagnated;
  return std::isfinite(quickest) && has_time ? SearchOutcome::expected_slower : SearchOutcome::out_of_time;
}

void conclude_within(SearchCandidate& of, const ErrorTarget& target, const RefinementRun& best) {
  of.outcome = SearchOutcome::accuracy_reached;
  of.best = best;
  const ErrorModel model(doubled_errors(of.refinement, target.kind, best.steps - 1));
  if (!of.refinement.is_adaptive && !model.empty()) of.predicted = model.error(best.steps);
}

}  // namespace

void conclude(SearchCandidate& of, const ErrorTarget& target, double quickest, bool has_time) {
  const bool is_known = of.outcome == SearchOutcome::refused || of.outcome == SearchOutcome::duplicate;
  if (is_known || of.refinement.runs.empty()) return;
  const RefinementRun& finest = *of.refinement.finest();
  if (finest.seconds)
    of.seconds_per_step = (*finest.seconds - finest.counted_setup()) / std::max(1, finest.steps);
  const auto errors = doubled_errors(of.refinement, target.kind);
  of.rate = observed_rate(errors);
  if (const auto* best = quickest_within(of.refinement, target)) {
    conclude_within(of, target, *best);
    return;
  }
  if (finest.ending.kind != SolveStatus::finished) of.reason = sentence(finest.ending);
  of.outcome = outcome_outside(of.refinement, target, quickest, has_time);
  constexpr double begun = 0.1;  // of the error of a constant: from there on the error follows its rate
  const ErrorModel model(errors);
  const bool is_asymptotic = !errors.empty() && errors.back().error < begun * finest.error().baseline;
  if (!model.empty() && is_asymptotic)
    of.steps_needed = steps_beyond(finest.steps, model.steps(target.error));
}

}  // namespace fde::bench
