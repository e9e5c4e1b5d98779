// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/next_resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <string>

namespace fde::bench {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();  // seconds

using NextRun = std::optional<StepsOrTolerance>;

// A configuration can be the cheapest only while its runs outside the target take less than this multiple of
// the quickest run within it; measured times differ by some percent.
constexpr double near = 1.2;

// The part of most_seconds up to which the first runs of a configuration, fewest_runs of them, are made.
constexpr double early_part = 0.1;

// Whether a configuration cannot be the cheapest, asked before a run that takes so many seconds.
using IsOutOfReach = std::function<bool(double next_seconds)>;

// The runs of one configuration by their number of steps, seen against one target.
class StepsSearch {
 public:
  // least_step: the seconds of the cheapest step of any configuration.
  StepsSearch(const SearchGoal& goal, const Refinement& of, const ErrorTarget& target, double quickest,
              double least_step)
      : goal_(goal), of_(of), target_(target), quickest_(quickest), least_step_(least_step) {
    for (const RefinementRun& run : of.runs) runs_.insert_or_assign(std::get<int>(run.resolution), &run);
    const auto within = std::ranges::find_if(runs_, [&](const auto& run) { return is_in(*run.second); });
    if (within != runs_.end()) fewest_ = within->first;
  }

  // Without a run within the target.
  [[nodiscard]] NextRun refined(const IsOutOfReach& is_out_of_reach) const {
    if (const auto crossing = sign_change(runs_.rbegin()->first)) return crossing;
    const auto& [steps, finest] = *runs_.rbegin();
    if (steps > goal_.most_steps / 2 || has_stagnated(of_, target_.kind)) return std::nullopt;
    const double next = seconds_with(of_, 2.0 * steps).value_or(0.0);
    if (next - start_seconds(of_) > goal_.most_seconds) return std::nullopt;
    if (runs_.size() < goal_.fewest_runs && next <= early_part * goal_.most_seconds) return 2 * steps;
    if (least_seconds(*finest) > goal_.margin * quickest_) return std::nullopt;
    return is_out_of_reach(next) ? std::nullopt : NextRun(2 * steps);
  }

  // With a run within the target.
  [[nodiscard]] NextRun narrowed(const IsOutOfReach& is_out_of_reach) const {
    const auto next = runs_.find(fewest_);
    if (next == runs_.begin()) {
      const bool is_least = fewest_ <= of_.unit || is_out_of_reach(next->second->seconds.value_or(0.0));
      return is_least ? std::nullopt : NextRun(multiple(0.5 * fewest_));
    }
    const auto& [below, outside] = *std::prev(next);
    if (least_seconds(*outside) > near * quickest_) return std::nullopt;
    if (fewest_ - below > grain(below) && fewest_ > goal_.closeness * below) return between(below);
    if (const auto crossing = sign_change(below)) return crossing;
    return may_be_irregular() ? scanned() : std::nullopt;
  }

  [[nodiscard]] bool is_reached() const { return fewest_ > 0; }

 private:
  [[nodiscard]] bool is_in(const RefinementRun& run) const { return is_within(run, target_); }

  [[nodiscard]] double error(int steps) const { return error_of(*runs_.at(steps), target_.kind).value; }

  // A run to the end with as many steps takes at least this long: a run that failed may have failed late, by
  // iterations that do not converge, or at once.
  [[nodiscard]] double least_seconds(const RefinementRun& run) const {
    const bool finished = std::isfinite(error_of(run, target_.kind).value);
    return finished ? run.seconds.value_or(0.0) : run.steps * least_step_;
  }

  [[nodiscard]] int multiple(double steps) const {
    return std::max(of_.unit, static_cast<int>(steps / of_.unit) * of_.unit);
  }

  // The unit of numbers of steps above this one that have few enough binary digits.
  [[nodiscard]] int grain(int steps) const {
    return std::max(of_.unit, static_cast<int>(std::bit_floor(static_cast<unsigned>(steps)) >>
                                               static_cast<unsigned>(goal_.binary_digits - 1)));
  }

  // The secant between the most steps outside and the fewest within, a little to the side of its root that
  // the last run was not on, so that the bracket closes from both sides; the middle where the secant fails.
  [[nodiscard]] int between(int below) const {
    constexpr double little_more = 1.003, little_less = 0.993, edge = 0.02;
    const double low = error(below), high = error(fewest_);
    double part = 0.5;
    if (std::isfinite(low) && low > high && high > 0.0 && target_.error < low && !is_lopsided(below))
      part = std::log(low / target_.error) / std::log(low / high);
    part = std::clamp(part, edge, 1.0 - edge);
    const double root = below * std::pow(static_cast<double>(fewest_) / below, part),
                 steps = root * (of_.runs.back().steps == fewest_ ? little_less : little_more);
    const int unit = grain(below);
    return std::clamp(static_cast<int>(std::ceil(steps / unit)) * unit, below + unit, fewest_ - unit);
  }

  // Whether the last three runs all lie at one end of the bracket: then the secant converges slowly.
  [[nodiscard]] bool is_lopsided(int below) const {
    if (of_.runs.size() < 5) return false;
    const auto last = std::span(of_.runs).last(3);
    const auto at = [&](const RefinementRun& run) {
      return run.steps >= fewest_ ? 1 : run.steps <= below ? -1 : 0;
    };
    return at(last[0]) != 0 && at(last[0]) == at(last[1]) && at(last[1]) == at(last[2]);
  }

  // Between two neighbouring numbers of steps, up to `most`, where the error changes its sign: the middle.
  [[nodiscard]] NextRun sign_change(int most) const {
    for (auto right = runs_.begin(); right != runs_.end() && right->first <= most; ++right) {
      if (right == runs_.begin()) continue;
      const auto left = std::prev(right);
      if (right->first - left->first < 2 * of_.unit || is_in(*right->second)) continue;
      if (left->second->seconds.value_or(0.0) > goal_.margin * quickest_) continue;
      if (error_sign(*left->second) * error_sign(*right->second) >= 0.0) continue;
      return multiple(0.5 * (left->first + right->first));
    }
    return std::nullopt;
  }

  [[nodiscard]] double error_sign(const RefinementRun& run) const {
    const double value = error_of(run, target_.kind).signed_value;
    return value == 0.0 || !std::isfinite(value) ? 0.0 : std::copysign(1.0, value);
  }

  // Whether fewer steps may be within the target though some number in between is not.
  [[nodiscard]] bool may_be_irregular() const {
    constexpr int few_steps = 64;
    return (target_.may_pass_zero || fewest_ <= few_steps) &&
           runs_.at(fewest_)->seconds.value_or(never) <= goal_.most_seconds_scanned;
  }

  // Numbers of steps below the fewest, a twentieth apart, down to a sixteenth of it.
  [[nodiscard]] NextRun scanned() const {
    constexpr double ratio = 1.05, part = 16.0;
    for (int steps = fewest_; steps > of_.unit && steps * part > fewest_;) {
      steps = std::min(steps - of_.unit, multiple(steps / ratio));
      if (steps < of_.unit) break;
      if (!runs_.contains(steps)) return steps;
    }
    return std::nullopt;
  }

  const SearchGoal& goal_;
  const Refinement& of_;
  const ErrorTarget& target_;
  double quickest_, least_step_;
  std::map<int, const RefinementRun*> runs_{};
  int fewest_ = 0;  // within the target; 0: none
};

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
  if (best == nullptr || *best->seconds > near * quickest) return std::nullopt;
  const double at = std::get<Tolerance>(best->resolution).rtol;
  for (const double factor : {half, quarter, 1.0 / quarter, 1.0 / half}) {
    if (factor < 1.0 && is_settled) continue;
    if (const auto next = untried(goal, of, at * factor)) return next;
  }
  return std::nullopt;
}

bool is_repeated(std::span<const Refinement> of_scene, const Refinement& of) {
  return std::ranges::any_of(of_scene.first(static_cast<std::size_t>(&of - of_scene.data())),
                             [&](const Refinement& earlier) { return is_same_algorithm(earlier, of); });
}

NextRun first_of(const SearchGoal& goal, const Refinement& of) {
  if (of.is_adaptive) return Tolerance{goal.loosest, goal.loosest};
  return std::max(1, (goal.coarsest_steps + of.unit - 1) / of.unit) * of.unit;
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
    const StepsSearch search(goal_, of, target_, quickest_, least_step());
    return search.is_reached() ? search.narrowed(out_of_reach) : search.refined(out_of_reach);
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
    if (least_step_) return *least_step_;
    double least = never;
    for (const Refinement& of : of_scene_) {
      for (const RefinementRun& run : of.runs) {
        const bool finished = std::isfinite(error_of(run, target_.kind).value);
        if (finished && run.seconds && !of.is_adaptive && !run.is_whole_process)
          least = std::min(least, *run.seconds / run.steps);
      }
    }
    return least_step_.emplace(std::isfinite(least) ? least : 0.0);
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
  std::vector<double> seconds(next.size(), never);  // expected
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (!next[i]) continue;
    const auto& runs = of_scene[i].runs;
    const auto* steps = std::get_if<int>(&*next[i]);
    const auto expected = steps != nullptr ? seconds_with(of_scene[i], *steps)
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
