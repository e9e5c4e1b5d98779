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

using RunsByTolerance = std::map<double, const RefinementRun*>;

// The seconds of a run with a tolerance so many decades below the finest, by how the last ones grew.
double seconds_of_next(const RunsByTolerance& runs, int decades) {
  constexpr double most_growth = 10.0;
  const auto& [fine, finest] = *runs.begin();
  const double seconds = finest->seconds.value_or(0.0);
  if (runs.size() < 2 || !std::next(runs.begin())->second->seconds || seconds == 0.0) return seconds;
  const auto& [coarse, other] = *std::next(runs.begin());
  const double power = 1.0 / std::log10(coarse / fine);
  return seconds *
         std::pow(std::clamp(std::pow(seconds / *other->seconds, power), 1.0, most_growth), decades);
}

// The power of the tolerance with which the error falls from one run to another; 0 where it does not.
double error_power(const RefinementRun& coarse, const RefinementRun& fine, std::size_t kind) {
  const double from = error_of(coarse, kind).value, to = error_of(fine, kind).value;
  if (!std::isfinite(from) || !(to > 0.0) || to >= from) return 0.0;
  return std::log(from / to) /
         std::log(std::get<Tolerance>(coarse.resolution).rtol / std::get<Tolerance>(fine.resolution).rtol);
}

// By how many decades the next tolerance is smaller than the finest: more than one before long runs, where
// the errors of the two finest runs leave the target further away and the time allows.
int decades_to_next(const SearchGoal& goal, const RunsByTolerance& runs, const ErrorTarget& target) {
  constexpr int most = 3;
  const RefinementRun& finest = *runs.begin()->second;
  if (runs.size() < 2 || finest.seconds.value_or(0.0) < goal.long_run) return 1;
  const double power = error_power(*std::next(runs.begin())->second, finest, target.kind);
  if (power == 0.0) return 1;
  const double needed = std::log10(error_of(finest, target.kind).value / target.error) / power;
  auto decades = static_cast<int>(std::clamp(needed, 1.0, 1.0 * most));
  while (decades > 1 && seconds_of_next(runs, decades) > goal.most_seconds) --decades;
  return decades;
}

// Whether the errors of the run and of the next one with a looser tolerance expect an error far outside the
// target at a tolerance in between.
bool is_outside_between(const RunsByTolerance& runs, double tolerance, const ErrorTarget& target) {
  constexpr double far = 2.0;
  const auto looser = runs.upper_bound(tolerance);
  if (looser == runs.end() || looser == runs.begin()) return false;
  const auto& [fine, run] = *std::prev(looser);
  const double power = error_power(*looser->second, *run, target.kind);
  return error_of(*run, target.kind).value * std::pow(tolerance / fine, power) > far * target.error;
}

// Whether the finest run ended for want of time of which there is clearly more now.
bool may_take_longer(const SearchGoal& goal, const RefinementRun& finest) {
  constexpr double clearly = 4.0;
  return finest.ending.kind == SolveStatus::out_of_budget && finest.seconds &&
         goal.budget_of_tolerance >= clearly * *finest.seconds;
}

}  // namespace

NextRun next_tolerance(const SearchGoal& goal, const Refinement& of, const ErrorTarget& target,
                       double quickest, const IsOutOfReach& is_out_of_reach) {
  constexpr double decade = 10.0, quarter = 1.7782794100389228, half = 3.1622776601683795;
  RunsByTolerance runs;
  for (const RefinementRun& run : of.runs) runs.emplace(std::get<Tolerance>(run.resolution).rtol, &run);
  const auto& [tightest, finest] = *runs.begin();
  if (!std::isfinite(quickest) && may_take_longer(goal, *finest)) return finest->resolution;
  const RefinementRun* best = quickest_within(of, target);
  const int decades = best == nullptr ? decades_to_next(goal, runs, target) : 1;
  const double seconds = finest->seconds.value_or(0.0), next_seconds = seconds_of_next(runs, decades);
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
    if (const auto next = untried(goal, of, tightest / std::pow(decade, decades))) return next;
  }
  if (best == nullptr || *best->seconds > near_quickest * quickest) return std::nullopt;
  const double at = std::get<Tolerance>(best->resolution).rtol;
  for (const double factor : {half, quarter, 1.0 / quarter, 1.0 / half}) {
    if (is_settled && (factor < 1.0 || is_outside_between(runs, at * factor, target))) continue;
    if (const auto next = untried(goal, of, at * factor)) return next;
  }
  return std::nullopt;
}

}  // namespace fde::bench
