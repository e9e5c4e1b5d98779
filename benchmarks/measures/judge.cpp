#include "measures/judge.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "march/singularity.hpp"
#include "measures/accuracy.hpp"

namespace fde {
namespace {

// The reference at the times of a path, or the reason why there is none.
struct Known {
  Rows reference{}, bounds{};
  std::optional<RunEnding> missing{};
};
Known known_beside(const Trajectory& path, WatchedReference& reference) {
  try {
    return {reference.at(path.times), reference.bounds(path.times)};
  } catch (const Singularity& failure) {
    return {.missing = RunEnding{Ending::passed_singularity, failure.what()}};
  } catch (const std::runtime_error& failure) {
    return {.missing = RunEnding{Ending::no_reference, failure.what()}};
  }
}

// A run that stopped at the boundary of the domain is right, unless the solution stays inside.
Judgement judge_stopped(const Scene& scene, const Trajectory& path, WatchedReference& reference) {
  RunEnding ending = ending_of(scene.problem, path);
  if (ending.kind == Ending::singular && !known_beside(path, reference).missing)
    ending.kind = Ending::false_singularity;
  return {std::move(ending), path.reached};
}

// The judgement of a finished run, without measures.
Judgement judge_finished(const Trajectory& path, const Rows& values, const Known& known,
                         const Observed& observed) {
  const double end = path.times.back();
  if (known.missing) return {*known.missing, end};
  const auto lost = accuracy_lost(values, known.reference);
  if (!lost) return {{}, end};
  const bool overflows = lost == first_overflow(known.reference);
  const double t = path.time(*lost);
  return {{overflows ? Ending::overflow : Ending::accuracy_lost, at_time(observed.grid, t)}, t};
}

void take_measures(const FinishedRun& run, Judgement& judgement) {
  for (const auto* measure : measures()) {
    const auto value = measure->value(run);
    if (!value) continue;
    if (!std::isfinite(*value)) {
      judgement = {{Ending::not_finite, fmt::format("in {}", measure->id)}, run.path.times.back()};
      return;
    }
    judgement.measured.push_back({measure->id, measure->unit, *value});
  }
}

Judgement judge_values(const Trajectory& path, const Rows& values, WatchedReference& reference,
                       const Observed& observed) {
  const Known known = known_beside(path, reference);
  Judgement judgement = judge_finished(path, values, known, observed);
  if (known.reference.allFinite())
    take_measures({path, values, known.reference, known.bounds, observed}, judgement);
  return judgement;
}

}  // namespace

Judgement judge(const Scene& scene, const Trajectory& path, WatchedReference& reference,
                const Observed& observed) {
  return judge(scene, path, columns_of(scene.outputs, path), reference, observed);
}

Judgement judge(const Scene& scene, const Trajectory& path, const Rows& columns, WatchedReference& reference,
                const Observed& observed) {
  if (path.ending != Ending::finished) return judge_stopped(scene, path, reference);
  return judge_values(path, columns, reference, observed);
}

Judgement judge_columns(const std::vector<double>& times, const Rows& columns, WatchedReference& reference,
                        const Observed& observed) {
  return judge_values({.times = times, .y = columns}, columns, reference, observed);
}

}  // namespace fde
