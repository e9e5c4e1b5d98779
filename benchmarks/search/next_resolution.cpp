// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/next_resolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdebench/benchmarks/search/next_steps.hpp"
#include "fdebench/benchmarks/search/next_tolerance.hpp"

namespace fde::bench {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();  // seconds

bool is_repeated(std::span<const Refinement> of_scene, const Refinement& of) {
  return std::ranges::any_of(of_scene.first(static_cast<std::size_t>(&of - of_scene.data())),
                             [&](const Refinement& earlier) { return is_same_algorithm(earlier, of); });
}

NextRun first_of(const SearchGoal& goal, const Refinement& of) {
  if (of.is_adaptive) return Tolerance{goal.loosest, goal.loosest};
  return std::max(1, (goal.coarsest_steps + of.unit - 1) / of.unit) * of.unit;
}

bool is_finished(const RefinementRun& run) {
  return std::ranges::any_of(run.errors, [](const RunError& error) { return std::isfinite(error.value); });
}

// The seconds of the cheapest step over a grid of any configuration; 0 before a run has finished.
double seconds_of_cheapest_step(std::span<const Refinement> of_scene) {
  double least = never;
  for (const Refinement& of : of_scene) {
    for (const RefinementRun& run : of.runs) {
      if (is_finished(run) && run.seconds && !of.is_adaptive && !run.is_whole_process)
        least = std::min(least, *run.seconds / run.steps);
    }
  }
  return std::isfinite(least) ? least : 0.0;
}

// All configurations seen against one target.
class TargetSearch {
 public:
  TargetSearch(const SearchGoal& goal, std::span<const Refinement> of_scene, const ErrorTarget& target,
               double quickest, ForecastMemo& memo)
      : goal_(goal), of_scene_(of_scene), target_(target), quickest_(quickest), memo_(memo) {}

  [[nodiscard]] bool is_reached() const { return quickest_ < never; }

  // by_forecasts: without configurations that are forecast to be slower than another; otherwise only without
  // those that are forecast to take longer than any run may.
  NextRun next(const Refinement& of, bool by_forecasts) {
    const auto out_of_reach = [&](double next_seconds) {
      return is_out_of_reach(of, next_seconds, by_forecasts);
    };
    if (of.is_adaptive) return next_tolerance(goal_, of, target_, quickest_, out_of_reach);
    return next_steps(goal_, of, target_, quickest_, least_step(), out_of_reach);
  }

 private:
  // Whether even the shortest forecast, or without one the next run, takes longer than another configuration
  // needs, by the margin, or than a run may.
  bool is_out_of_reach(const Refinement& of, double next_seconds, bool by_others) {
    constexpr double hope = 0.8;
    if (next_seconds < (of.is_adaptive ? goal_.long_run : goal_.long_run_over_grid)) return false;
    const auto own = forecast(of);
    const double least = own ? hope * own->low : next_seconds;
    return least > (by_others ? goal_.margin * least_forecast() : goal_.most_seconds);
  }

  const std::optional<Prediction>& forecast(const Refinement& of) {
    const auto i = static_cast<std::size_t>(&of - of_scene_.data());
    const std::tuple key{i, of.runs.size(), target_.kind};
    auto known = memo_.find(key);
    if (known == memo_.end())
      known = memo_.emplace(key, ConfigurationForecast{error_model(of, target_.kind)}).first;
    auto& [model, seconds] = known->second;
    const auto [forecast, is_new] = seconds.try_emplace(target_.error);
    if (is_new) forecast->second = forecast_seconds(of, target_, model);
    return forecast->second;
  }

  // The least seconds that a configuration is measured or forecast to need, at the end of its interval.
  double least_forecast() {
    if (least_forecast_) return *least_forecast_;
    double least = quickest_;
    for (const Refinement& of : of_scene_) {
      if (of.runs.empty() || quickest_within(of, target_) != nullptr) continue;
      if (const auto expected = forecast(of)) least = std::min(least, expected->high);
    }
    return least_forecast_.emplace(least);
  }

  double least_step() {
    if (!least_step_) least_step_ = seconds_of_cheapest_step(of_scene_);
    return *least_step_;
  }

  const SearchGoal& goal_;
  std::span<const Refinement> of_scene_;
  const ErrorTarget& target_;
  double quickest_;
  ForecastMemo& memo_;
  std::optional<double> least_forecast_{}, least_step_{};
};

}  // namespace

std::vector<double> quickest_seconds(const SearchGoal& goal, std::span<const Refinement> of_scene) {
  std::vector<double> seconds;
  for (const ErrorTarget& target : goal.targets) {
    double least = never;
    for (const Refinement& of : of_scene)
      if (const auto* run = quickest_within(of, target)) least = std::min(least, *run->seconds);
    seconds.push_back(least);
  }
  return seconds;
}

std::vector<std::optional<StepsOrTolerance>> next_resolutions(const SearchGoal& goal,
                                                              std::span<const Refinement> of_scene) {
  ForecastMemo memo;
  return next_resolutions(goal, of_scene, memo);
}

std::vector<std::optional<StepsOrTolerance>> next_resolutions(const SearchGoal& goal,
                                                              std::span<const Refinement> of_scene,
                                                              ForecastMemo& memo) {
  const auto quickest = quickest_seconds(goal, of_scene);
  std::vector<TargetSearch> searches;
  for (std::size_t k = 0; k < goal.targets.size(); ++k)
    searches.emplace_back(goal, of_scene, goal.targets[k], quickest[k], memo);
  const auto next_of = [&](const Refinement& of, bool by_forecasts) -> NextRun {
    if (of.is_closed) return std::nullopt;
    if (of.runs.empty()) return first_of(goal, of);
    const bool is_hopeless = !of.is_adaptive && of.runs.back().fails_with_more_steps;
    if (is_hopeless || is_repeated(of_scene, of)) return std::nullopt;
    for (TargetSearch& search : searches) {
      if (!by_forecasts && search.is_reached()) continue;
      if (const auto run = search.next(of, by_forecasts)) return run;
    }
    return std::nullopt;
  };
  // A forecast may be of a configuration that does not keep it: before the search ends, those that it held
  // back try the targets that no run has reached.
  std::vector<NextRun> next(of_scene.size());
  for (const bool by_forecasts : {true, false}) {
    std::ranges::transform(of_scene, next.begin(),
                           [&](const Refinement& of) { return next_of(of, by_forecasts); });
    if (std::ranges::any_of(next, &NextRun::has_value)) break;
  }
  return next;
}

std::vector<std::size_t> due_runs(const SearchGoal& goal, std::span<const Refinement> of_scene,
                                  std::span<const std::optional<StepsOrTolerance>> next) {
  constexpr double alike = 4.0;
  const double cheapest_step = seconds_of_cheapest_step(of_scene);
  // A run that failed may have failed early, and with more steps end late.
  const auto expected_over_grid = [&](const Refinement& of, int steps) -> std::optional<double> {
    const auto expected = seconds_with(of, steps);
    if (!expected || is_finished(*of.finest())) return expected;
    return std::max(*expected, steps * cheapest_step);
  };
  std::vector<double> seconds(next.size(), never);  // expected
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (!next[i]) continue;
    const auto& runs = of_scene[i].runs;
    const auto* steps = std::get_if<int>(&*next[i]);
    const auto expected = steps != nullptr ? expected_over_grid(of_scene[i], *steps)
                          : runs.empty()   ? std::nullopt
                                           : runs.back().seconds;
    seconds[i] = expected.value_or(0.0);
  }
  std::vector<std::size_t> due;
  if (seconds.empty()) return due;
  const double most = std::max(alike * std::ranges::min(seconds), goal.short_run);
  for (std::size_t i = 0; i < next.size(); ++i)
    if (next[i] && seconds[i] <= most) due.push_back(i);
  return due;
}

}  // namespace fde::bench
