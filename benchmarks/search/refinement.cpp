// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace fde::bench {
namespace {

// The runs with numbers of steps, each number once, from coarse to fine.
std::map<int, const RefinementRun*> by_steps(const Refinement& of) {
  std::map<int, const RefinementRun*> runs;
  for (const RefinementRun& run : of.runs)
    if (const auto* steps = std::get_if<int>(&run.resolution)) runs.insert_or_assign(*steps, &run);
  return runs;
}

bool is_finite(const RunError& error) { return std::isfinite(error.value); }

// Errors that are all 0, as of a constant solution, or infinite do not show which algorithm has them.
bool is_telling(const RefinementRun& run) {
  return std::ranges::any_of(run.errors,
                             [](const RunError& error) { return error.value > 0.0 && is_finite(error); });
}

bool are_equal(const RefinementRun& a, const RefinementRun& b) {
  return std::ranges::equal(a.errors, b.errors, {}, &RunError::value, &RunError::value);
}

}  // namespace

void Refinement::add(RefinementRun run) {
  if (is_adaptive) {
    const auto same = std::ranges::find(runs, run.resolution, &RefinementRun::resolution);
    if (same == runs.end()) {
      runs.push_back(std::move(run));
    } else {
      *same = std::move(run);
    }
    return;
  }
  runs.push_back(std::move(run));
  std::vector<RefinementRun*> ended;
  for (RefinementRun& made : runs)
    if (made.seconds && std::ranges::any_of(made.errors, is_finite)) ended.push_back(&made);
  std::ranges::sort(ended, std::greater{}, &RefinementRun::steps);
  double least = std::numeric_limits<double>::infinity();
  for (RefinementRun* made : ended) made->seconds = least = std::min(least, *made->seconds);
}

const RefinementRun* Refinement::finest() const {
  const auto fineness = [](const RefinementRun& run) {
    const auto* tolerance = std::get_if<Tolerance>(&run.resolution);
    return tolerance != nullptr ? -tolerance->rtol : run.steps;
  };
  const auto found = std::ranges::max_element(runs, {}, fineness);
  return found == runs.end() ? nullptr : &*found;
}

RunError error_of(const RefinementRun& run, std::size_t kind) {
  return kind < run.errors.size() ? run.errors[kind] : RunError{};
}

bool is_within(const RefinementRun& run, const ErrorTarget& target) {
  const RunError error = error_of(run, target.kind);
  return error.value <= target.error && error.value < error.baseline;
}

const RefinementRun* quickest_within(const Refinement& of, const ErrorTarget& target) {
  const RefinementRun* best = nullptr;
  for (const RefinementRun& run : of.runs) {
    if (!run.seconds || !is_within(run, target)) continue;
    if (best == nullptr || std::pair(*run.seconds, run.steps) < std::pair(*best->seconds, best->steps))
      best = &run;
  }
  return best;
}

std::vector<TrialError> doubled_errors(const Refinement& of, std::size_t kind, int most) {
  constexpr double nearly_two = 1.9;
  std::vector<TrialError> errors;
  const auto runs = by_steps(of);
  const std::vector<std::pair<int, const RefinementRun*>> from_finest(runs.rbegin(), runs.rend());
  for (const auto& [steps, made] : from_finest) {
    const double error = error_of(*made, kind).value;
    if (steps > most || !std::isfinite(error)) continue;
    if (errors.empty() || nearly_two * steps <= errors.back().steps) errors.push_back({steps, error});
  }
  std::ranges::reverse(errors);
  return errors;
}

bool has_stagnated(const Refinement& of, std::size_t kind) {
  constexpr double small = 1e-8, falling = 0.7;
  const auto runs = by_steps(of);
  if (runs.empty()) return false;
  if (error_of(*runs.rbegin()->second, kind).is_stagnant) return true;
  const auto errors = doubled_errors(of, kind);
  if (errors.size() < 3) return false;
  const double baseline = error_of(*runs.rbegin()->second, kind).baseline,
               size = std::isfinite(baseline) ? baseline
                                              : std::ranges::max(errors, {}, &TrialError::error).error;
  const auto last = std::span(errors).last(3);
  return last[2].error < small * size && last[2].error > falling * last[1].error &&
         last[1].error > falling * last[0].error;
}

double start_seconds(const Refinement& of) {
  double least = 0.0;
  for (const RefinementRun& run : of.runs) {
    if (run.counted_setup() > 0.0) return of.runs.back().counted_setup();
    if (!run.is_whole_process || !run.seconds) continue;
    least = least > 0.0 ? std::min(least, *run.seconds) : *run.seconds;
  }
  return least;
}

namespace {

// The power of the number of steps with which the time of a run grows: 1, or more where it is seen in runs
// that take long enough to be measured well.
double growth_power(const RefinementRun& coarse, const RefinementRun& fine) {
  constexpr double well_measured = 1e-3, most = 4.0;
  if (*coarse.seconds < well_measured || *fine.seconds < *coarse.seconds) return 1.0;
  const double steps = std::log(static_cast<double>(fine.steps) / coarse.steps);
  return std::clamp(std::log(*fine.seconds / *coarse.seconds) / steps, 1.0, most);
}

}  // namespace

std::optional<double> seconds_with(const Refinement& of, double steps) {
  constexpr std::size_t trusted = 3;
  const double start = start_seconds(of);
  std::vector<const RefinementRun*> timed;
  for (const auto& [number, run] : by_steps(of))
    if (run->seconds) timed.push_back(run);
  if (timed.empty()) return std::nullopt;
  double step = std::numeric_limits<double>::infinity();
  for (const RefinementRun* run : std::span(timed).last(std::min(trusted, timed.size()))) {
    const double own_start = run->counted_setup() > 0.0 ? run->counted_setup() : start;
    const bool is_start = own_start > 0.0 && *run->seconds <= own_start && timed.size() > 1;
    if (!is_start) step = std::min(step, (*run->seconds - own_start) / run->steps);
  }
  const int finest = timed.back()->steps;
  if (timed.size() < 2 || start > 0.0 || steps <= finest) return start + step * steps;
  const double power = growth_power(*timed[timed.size() - 2], *timed.back());
  return step * steps * std::pow(steps / finest, power - 1.0);
}

namespace {

// With tolerances the time is a power of the error, to a factor of two: by the run with the smallest error
// and the one with the smallest error that is far enough from it, because both error and time scatter.
std::optional<Prediction> forecast_by_tolerances(const Refinement& of, const ErrorTarget& target) {
  constexpr double uncertainty = 2.0, far = 30.0;
  std::map<double, double> seconds;  // by error
  for (const RefinementRun& run : of.runs) {
    const double error = error_of(run, target.kind).value;
    if (run.seconds && error > 0.0 && std::isfinite(error)) seconds.insert_or_assign(error, *run.seconds);
  }
  if (seconds.empty()) return std::nullopt;
  const auto [fine, fine_seconds] = *seconds.begin();
  const auto other = seconds.lower_bound(far * fine);
  if (other == seconds.end()) return std::nullopt;
  const auto [coarse, coarse_seconds] = *other;
  const double power =
      std::clamp(std::log(fine_seconds / coarse_seconds) / std::log(coarse / fine), 0.0, 1.0);
  const double value = fine_seconds * std::pow(fine / target.error, power);
  return Prediction{value, value / uncertainty, value * uncertainty};
}

}  // namespace

ErrorModel error_model(const Refinement& of, std::size_t kind) {
  constexpr std::size_t fewest = 3;
  const auto errors = of.is_adaptive ? std::vector<TrialError>() : doubled_errors(of, kind);
  return errors.size() < fewest ? ErrorModel({}) : ErrorModel(errors);
}

std::optional<Prediction> forecast_seconds(const Refinement& of, const ErrorTarget& target,
                                           const ErrorModel& model) {
  if (of.is_adaptive) return forecast_by_tolerances(of, target);
  if (model.empty() || !seconds_with(of, 1.0)) return std::nullopt;
  const Prediction steps = model.steps(target.error);
  return Prediction{*seconds_with(of, steps.value), *seconds_with(of, steps.low),
                    *seconds_with(of, steps.high)};
}

bool is_same_algorithm(const Refinement& a, const Refinement& b, int fewest) {
  if (a.is_adaptive || b.is_adaptive || a.runs.empty() || b.runs.empty()) return false;
  const bool same_start = a.runs.front().resolution == b.runs.front().resolution;
  if (same_start && !are_equal(a.runs.front(), b.runs.front())) return false;
  const auto others = by_steps(b);
  int common = 0;
  for (const auto& [steps, run] : by_steps(a)) {
    const auto other = others.find(steps);
    if (other == others.end()) continue;
    if (!are_equal(*run, *other->second)) return false;
    common += is_telling(*run) ? 1 : 0;
  }
  return common >= fewest;
}

}  // namespace fde::bench
