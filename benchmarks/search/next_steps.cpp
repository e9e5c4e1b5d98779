// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/next_steps.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <span>

namespace fde::bench {
namespace {

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
    if (least_seconds(*outside) > near_quickest * quickest_) return std::nullopt;
    if (fewest_ - below > grain(below) && fewest_ > goal_.closeness * below) return between(below);
    if (const auto crossing = sign_change(below)) return crossing;
    return may_be_irregular() ? scanned() : std::nullopt;
  }

  [[nodiscard]] bool is_reached() const { return fewest_ > 0; }

 private:
  [[nodiscard]] bool is_in(const RefinementRun& run) const { return is_within(run, target_); }

  [[nodiscard]] double error(int steps) const { return error_of(*runs_.at(steps), target_.kind).value; }

  // A run to the end with as many steps takes at least this long: a run that failed may have failed late, by
  // iterations that do not converge, or at once. Its steps up to where it grew beyond all numbers are as long
  // as those of a run that ends.
  [[nodiscard]] double least_seconds(const RefinementRun& run) const {
    const bool finished = std::isfinite(error_of(run, target_.kind).value),
               counts = finished || run.ending.kind == SolveStatus::non_finite;
    return std::max(counts ? run.seconds.value_or(0.0) : 0.0, finished ? 0.0 : run.steps * least_step_);
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
           runs_.at(fewest_)->seconds.value_or(std::numeric_limits<double>::infinity()) <=
               goal_.most_seconds_scanned;
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

}  // namespace

NextRun next_steps(const SearchGoal& goal, const Refinement& of, const ErrorTarget& target, double quickest,
                   double least_step, const IsOutOfReach& is_out_of_reach) {
  const StepsSearch search(goal, of, target, quickest, least_step);
  return search.is_reached() ? search.narrowed(is_out_of_reach) : search.refined(is_out_of_reach);
}

}  // namespace fde::bench
