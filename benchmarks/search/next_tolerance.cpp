// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/next_tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace fde::bench {
namespace {

// A tolerance of two digits, which prints as it is read.
double two_digits(double tolerance) { return std::stod(fmt::format("{:.1e}", tolerance)); }

bool has_tolerance(const Refinement& of, double tolerance) {
  return std::ranges::any_of(of.runs, [&](const RefinementRun& run) {
    return std::abs(std::log(std::get<Tolerance>(run.resolution).rtol / tolerance)) < 1e-6;
  });
}

NextRun untried(const SearchGoal& goal, const Refinement& of, double tolerance) {
  const double rounded = two_digits(tolerance);
  if (rounded > goal.loosest || rounded < goal.tightest || has_tolerance(of, rounded)) return std::nullopt;
  return Tolerance{rounded, rounded};
}

// The seconds of a run with a tolerance ten times smaller than the finest, by how the last ones grew.
double seconds_of_next(const std::map<double, const RefinementRun*>& runs) {
  constexpr double most_growth = 10.0;
  const auto& [fine, finest] = *runs.begin();
  const double seconds = finest->seconds.value_or(0.0);
  if (runs.size() < 2 || !std::next(runs.begin())->second->seconds || seconds == 0.0) return seconds;
  const auto& [coarse, other] = *std::next(runs.begin());
  const double power = 1.0 / std::log10(coarse / fine);
  return seconds * std::clamp(std::pow(seconds / *other->seconds, power), 1.0, most_growth);
}

}  // namespace

NextRun next_tolerance(const SearchGoal& goal, const Refinement& of, const ErrorTarget& target,
                       double quickest, const IsOutOfReach& is_out_of_reach) {
  constexpr double decade = 10.0, quarter = 1.7782794100389228, half = 3.1622776601683795;
  std::map<double, const RefinementRun*> runs;  // by tolerance
  for (const RefinementRun& run : of.runs) runs.emplace(std::get<Tolerance>(run.resolution).rtol, &run);
  const auto& [tightest, finest] = *runs.begin();
  const double seconds = finest->seconds.value_or(0.0), next_seconds = seconds_of_next(runs);
  const RefinementRun* best = quickest_within(of, target);
  const bool is_settled =
      best != nullptr && *best->seconds > goal.long_run;  // a tighter one takes longer still
  // A solution that one polynomial fits may take less time with a tighter tolerance, not only with the next.
  constexpr std::size_t fewest = 6;
  const bool is_early = of.runs.size() < std::max(goal.fewest_runs, seconds < goal.long_run ? fewest : 0) &&
                        next_seconds <= early_part * goal.most_seconds;
  const double counted = next_seconds < goal.long_run ? seconds : next_seconds;
  const bool is_promising = next_seconds <= goal.most_seconds && counted <= goal.margin * quickest &&
                            !error_of(*finest, target.kind).is_stagnant && !is_out_of_reach(next_seconds);
  if (!finest->fails_with_more_steps && !is_settled && (is_early || is_promising)) {
    if (const auto next = untried(goal, of, tightest / decade)) return next;
  }
  if (best == nullptr || *best->seconds > near_quickest * quickest) return std::nullopt;
  const double at = std::get<Tolerance>(best->resolution).rtol;
  for (const double factor : {half, quarter, 1.0 / quarter, 1.0 / half}) {
    if (factor < 1.0 && is_settled) continue;
    if (const auto next = untried(goal, of, at * factor)) return next;
  }
  return std::nullopt;
}

}  // namespace fde::bench
