// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/judge.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/measures/accuracy.hpp"
#include "fdebench/reference/nonlinear/march/march_limits.hpp"

namespace fde::bench {
namespace {

// The reference at the times of a path, or the reason why there is none.
struct ReferenceAtTimes {
  Rows reference{}, bounds{};
  std::optional<RunOutcome> missing{};
};
ReferenceAtTimes reference_at_times(const Trajectory& path, MemoizedReference& reference) {
  try {
    return {reference.at(path.times), reference.bounds(path.times)};
  } catch (const reference::Singularity& failure) {
    return {.missing = RunOutcome{Verdict::passed_singularity, failure.what()}};
  } catch (const std::runtime_error& failure) {
    return {.missing = RunOutcome{Verdict::no_reference, failure.what()}};
  }
}

// A run that stopped at the boundary of the domain is right, unless the solution stays inside.
Assessment judge_stopped(const Scene& scene, const Trajectory& path, MemoizedReference& reference) {
  RunOutcome ending = outcome_of(scene.problem, path);
  if (ending.kind == SolveStatus::left_domain && !reference_at_times(path, reference).missing)
    ending.kind = Verdict::false_singularity;
  return {std::move(ending), path.last_time};
}

// The judgement of a finished run, without measures.
Assessment judge_finished(const Trajectory& path, const Rows& values, const ReferenceAtTimes& known,
                          const RunObservations& observed) {
  const double end = path.times.back();
  if (known.missing) return {*known.missing, end};
  const auto overflow = first_not_finite(known.reference);
  // Comparisons would pass over a column without a value.
  if (const auto gap = first_not_finite(values); gap && (!overflow || *gap < *overflow)) {
    const double t = path.time(*gap);
    return {{SolveStatus::non_finite, at_time(observed.grid, t)}, t};
  }
  const auto lost = accuracy_lost(values, known.reference);
  if (!lost) return {{}, end};
  const bool overflows = lost == overflow;
  const double t = path.time(*lost);
  return {{overflows ? Verdict::overflow : Verdict::accuracy_lost, at_time(observed.grid, t)}, t};
}

// The errors of a scene with one column, or with too many, need no record of their own.
void take_column_errors(const FinishedRun& run, const ComparedColumns& compared, Assessment& judgement) {
  const bool is_needed =
      compared.is_part || (compared.names.size() > 1 && compared.names.size() <= most_single_columns);
  if (judgement.measured.empty() || !is_needed) return;
  judgement.columns = column_errors(run, compared.names, compared.is_part);
}

// Adds a value. Returns false, and the judgement is that of its run, if it is not finite.
bool take(const FinishedRun& run, const MeasuredValue& measured, Assessment& judgement) {
  if (!std::isfinite(measured.value)) {
    judgement = {{SolveStatus::non_finite, fmt::format("in {}", measured.id)}, run.path.times.back()};
    return false;
  }
  judgement.measured.push_back(measured);
  return true;
}

void take_measures(const FinishedRun& run, Assessment& judgement) {
  for (const auto* measure : measures()) {
    const auto value = measure->value(run);
    if (!value) continue;
    const auto course = measure->course != nullptr ? measure->course(run) : Course{};
    if (!take(run, {measure->id, measure->unit, *value, course}, judgement)) return;
  }
  for (const auto& [id, value_of] : run.observed.own) {
    const auto value = value_of(run.path.times, run.values, run.reference);
    if (value && !take(run, {id, "", *value}, judgement)) return;
  }
}

Assessment judge_values(const Trajectory& path, const Rows& values, MemoizedReference& reference,
                        const RunObservations& observed, const ComparedColumns& compared) {
  const ReferenceAtTimes known = reference_at_times(path, reference);
  Assessment judgement = judge_finished(path, values, known, observed);
  if (!known.reference.allFinite() || !values.allFinite()) return judgement;
  const FinishedRun run{path, values, known.reference, known.bounds, observed};
  take_measures(run, judgement);
  if (known.reference.cols() > 0) take_column_errors(run, compared, judgement);
  return judgement;
}

}  // namespace

Assessment judge(const Scene& scene, const Trajectory& path, MemoizedReference& reference,
                 const RunObservations& observed) {
  return judge(scene, path, columns_of(scene.outputs, path), reference, observed);
}

Assessment judge(const Scene& scene, const Trajectory& path, const Rows& columns,
                 MemoizedReference& reference, const RunObservations& observed) {
  if (path.status != SolveStatus::finished) return judge_stopped(scene, path, reference);
  return judge_values(path, columns, reference, observed, {.names = scene.outputs.names});
}

Assessment judge_columns(const std::vector<double>& times, const Rows& columns, MemoizedReference& reference,
                         const RunObservations& observed, const ComparedColumns& compared) {
  return judge_values({.times = times, .y = columns}, columns, reference, observed, compared);
}

}  // namespace fde::bench
