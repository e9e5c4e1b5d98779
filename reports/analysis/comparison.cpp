#include "fdebench/reports/analysis/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace fde {
namespace {

// The uncertainty of an error of a run, on the absolute scale.
double doubt(const MeasuredRun& run, std::string_view quantity) {
  constexpr double samples = 4.0;
  const double at_end = run["reference_bound"].value_or(0.0);  // older results have this bound only
  const double bound =
      quantity.starts_with("error_maximum") ? run["reference_bound_maximum"].value_or(at_end) : at_end;
  return samples * run["rounding"].value_or(0.0) + bound;
}

// The ratio of an error of this quantity to the absolute error at the end; 1 for absolute errors.
double unit_of(const MeasuredRun& run, std::string_view quantity, double error) {
  const double at_end = run["error_end"].value_or(0.0);
  const bool is_absolute = quantity == "error_end" || quantity == "error_maximum";
  return is_absolute || at_end == 0.0 ? 1.0 : error / at_end;
}

std::optional<ErrorChange> moved(const CommonRun& run, std::string_view quantity, double before, double now) {
  constexpr double part = 0.01;
  const double unknown = std::max(doubt(*run.before, quantity), doubt(*run.now, quantity)) *
                         std::min(unit_of(*run.before, quantity, before), unit_of(*run.now, quantity, now));
  if (std::abs(now - before) <= unknown) return std::nullopt;
  if (std::max(now, before) <= (1.0 + part) * std::min(now, before)) return std::nullopt;
  return ErrorChange{.run = run, .quantity = quantity, .before = before, .now = now};
}

double growth(const ErrorChange& error) {
  return error.before > 0.0 ? error.now / error.before : std::numeric_limits<double>::infinity();
}

void compare_errors(const CommonRun& run, std::vector<ErrorChange>& all) {
  std::optional<ErrorChange> worst;
  for (const auto& [quantity, before] : run.before->values) {
    const auto now = (*run.now)[quantity];
    if (!quantity.starts_with("error_") || !now) continue;
    const auto found = moved(run, quantity, before, *now);
    if (found && (!worst || growth(*found) > growth(*worst))) worst = found;
  }
  if (worst) all.push_back(*worst);
}

void compare_times(const CommonRun& run, Comparison& of) {
  const auto before = time_of(*run.before), now = time_of(*run.now);
  if (before && !now) ++of.timed_before;
  if (!before || !now || before->low <= 0.0 || now->low <= 0.0) return;
  if (run.before->wall_clock != run.now->wall_clock) return;
  of.times.push_back({.run = run,
                      .before = *before,
                      .now = *now,
                      .ratio = now->median / before->median,
                      .low = now->low / before->high,
                      .high = now->high / before->low});
}

void compare_endings(const CommonRun& run, std::vector<EndingChange>& all) {
  const Verdict before = verdict(*run.before), now = verdict(*run.now);
  if (before != now || run.before->ending.kind != run.now->ending.kind)
    all.push_back({.run = run, .before = before, .now = now});
}

// Larger is better. The verdicts with rank 1 are not comparable with each other.
int rank(const Verdict& verdict) {
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
std::map<RunKey, const MeasuredRun*> by_key(const Runs& runs) {
  std::map<RunKey, const MeasuredRun*> all;
  for (const auto* some : {&runs.finished, &runs.failed}) {
    for (const MeasuredRun& run : *some) all.emplace(run.key, &run);
  }
  return all;
}

}  // namespace

bool EndingChange::fell() const { return rank(now) < rank(before); }

bool Comparison::is_worse() const {
  return std::ranges::any_of(errors, &ErrorChange::grew) || std::ranges::any_of(endings, &EndingChange::fell);
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
    compare_errors(common, comparison.errors);
    compare_times(common, comparison);
    compare_endings(common, comparison.endings);
  }
  comparison.only_before = of_before.size() - comparison.common;
  comparison.only_now = of_now.size() - comparison.common;
  put_worst_first(comparison);
  return comparison;
}

}  // namespace fde
