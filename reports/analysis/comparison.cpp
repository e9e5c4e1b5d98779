// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "fdebench/benchmarks/measures/measures.hpp"
#include "fdebench/reports/analysis/compared_columns.hpp"

namespace fde::bench {
namespace {

// The uncertainty of an error of a run in this norm, on the absolute scale.
double uncertainty(const Record& run, Norm norm) {
  constexpr double samples = 4.0;
  const double at_end = run["reference_bound"].value_or(0.0);  // older results have this bound only
  const double bound = norm == Norm::maximum ? run["reference_bound_maximum"].value_or(at_end) : at_end;
  return samples * run["rounding"].value_or(0.0) + bound;
}

// The ratio of an error on this scale to the absolute error at the end; 1 for absolute errors.
double unit_of(const Record& run, Scale scale, double error) {
  const double at_end = run["error_end"].value_or(0.0);
  return scale == Scale::absolute || at_end == 0.0 ? 1.0 : error / at_end;
}

std::optional<ErrorChange> change_of(const CommonRun& run, const Measure& measure, double before,
                                     double now) {
  constexpr double part = 0.01;
  const auto [norm, scale] = *measure.error;
  const double unknown = std::max(uncertainty(*run.before, norm), uncertainty(*run.now, norm)) *
                         std::min(unit_of(*run.before, scale, before), unit_of(*run.now, scale, now));
  if (std::abs(now - before) <= unknown) return std::nullopt;
  if (std::max(now, before) <= (1.0 + part) * std::min(now, before)) return std::nullopt;
  return ErrorChange{.run = run, .quantity = measure.id, .before = before, .now = now};
}

double growth(const ErrorChange& error) {
  return error.before > 0.0 ? error.now / error.before : std::numeric_limits<double>::infinity();
}

void compare_errors(const CommonRun& run, std::vector<ErrorChange>& all) {
  std::optional<ErrorChange> worst;
  for (const Measure* measure : measures()) {
    const auto before = (*run.before)[measure->id], now = (*run.now)[measure->id];
    if (!measure->error || !before || !now) continue;
    const auto found = change_of(run, *measure, *before, *now);
    if (found && (!worst || growth(*found) > growth(*worst))) worst = found;
  }
  if (worst) all.push_back(*worst);
}

void compare_times(const CommonRun& run, Comparison& of) {
  const auto before = time_of(*run.before), now = time_of(*run.now);
  if (before && !now) ++of.timed_before;
  if (!before || !now || before->low <= 0.0 || now->low <= 0.0) return;
  if (run.before->timing.wall_clock != run.now->timing.wall_clock) return;
  of.times.push_back({.run = run,
                      .before = *before,
                      .now = *now,
                      .ratio = now->median / before->median,
                      .low = now->low / before->high,
                      .high = now->high / before->low});
}

void compare_endings(const CommonRun& run, std::vector<EndingChange>& all) {
  const TrialResult before = trial_result(*run.before), now = trial_result(*run.now);
  if (before != now || run.before->ending.kind != run.now->ending.kind)
    all.push_back({.run = run, .before = before, .now = now});
}

// Larger is better. The verdicts with rank 1 are not comparable with each other.
int rank(const TrialResult& verdict) {
  if (verdict == survives || verdict == stops) return 2;
  return verdict == fails ? 0 : 1;
}

void put_worst_first(Comparison& comparison) {
  const auto fall = [](const EndingChange& change) { return rank(change.now) - rank(change.before); };
  std::ranges::stable_sort(comparison.endings, {}, fall);
  std::ranges::stable_sort(comparison.errors, std::ranges::greater{}, growth);
  std::ranges::stable_sort(comparison.times, std::ranges::greater{}, &TimeRatio::ratio);
}

// All runs, finished and failed, by key.
std::map<RunKey, const Record*> by_key(const Runs& runs) {
  std::map<RunKey, const Record*> all;
  for (const auto* some : {&runs.finished, &runs.failed}) {
    for (const Record& run : *some) all.emplace(run.key, &run);
  }
  return all;
}

}  // namespace

bool EndingChange::is_worse() const { return rank(now) < rank(before); }

bool Comparison::is_worse() const {
  return std::ranges::any_of(errors, &ErrorChange::grew) ||
         std::ranges::any_of(endings, &EndingChange::is_worse);
}

std::ptrdiff_t Comparison::slower_than(double factor) const {
  return std::ranges::count_if(times, [&](const TimeRatio& time) { return time.low > factor; });
}

Comparison compare(const Runs& before, const Runs& now) {
  const auto of_before = by_key(before), of_now = by_key(now);
  Comparison comparison;
  for (const auto& [key, run] : of_before) {
    const auto found = of_now.find(key);
    if (found == of_now.end()) continue;
    const CommonRun common{.before = run, .now = found->second};
    ++comparison.common;
    const bool is_alike = compared_text(before, key.scene) == compared_text(now, key.scene);
    is_alike ? compare_errors(common, comparison.errors) : void(++comparison.unlike);
    compare_times(common, comparison);
    compare_endings(common, comparison.endings);
  }
  comparison.only_before = of_before.size() - comparison.common;
  comparison.only_now = of_now.size() - comparison.common;
  put_worst_first(comparison);
  return comparison;
}

}  // namespace fde::bench
