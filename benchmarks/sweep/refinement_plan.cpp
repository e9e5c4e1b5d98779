#include "fdebench/benchmarks/sweep/refinement_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fde {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t fewest_rungs = 5, fewest_accuracies = 3;

bool is_hopeless(Ending ending) {
  switch (ending) {
    case Ending::refused:
    case Ending::no_reference:
    case Ending::overflow:
    case Ending::singular:
    case Ending::passed_singularity:
    case Ending::out_of_budget:
    case Ending::program_failed:
      return true;
    default:
      return false;
  }
}

// The observed rate of the last two runs and the theoretical rate, the smaller first.
std::optional<std::pair<double, double>> rates_of(const Refinement& climb, NormMember of) {
  const RefinementRun& last = climb.back();
  if (last.steps == 0) return std::nullopt;
  std::vector<double> rates;
  if ((last.*of).rate) rates.push_back(*(last.*of).rate);
  if (climb.size() > 1 && (climb[climb.size() - 2].*of).error.value_or(0.0) > 0.0) {
    const RefinementRun& before = climb[climb.size() - 2];
    rates.push_back(std::log(*(before.*of).error / *(last.*of).error) /
                    std::log(static_cast<double>(last.steps) / before.steps));
  }
  if (rates.empty()) return std::nullopt;
  return std::minmax({rates.front(), rates.back()});
}

std::optional<double> measured_seconds(const Refinement& climb, NormMember of, double error) {
  double least = infinity;
  for (const RefinementRun& rung : climb) {
    if ((rung.*of).error.value_or(infinity) <= error)
      least = std::min(least, rung.seconds.value_or(infinity));
  }
  return least < infinity ? std::optional(least) : std::nullopt;
}

// The time to start a process: the time of the first run, 0 unless times are of whole processes.
double start_up(const Refinement& climb) {
  return climb.back().wall_clock ? climb.front().seconds.value_or(0.0) : 0.0;
}

// The forecast seconds for this number of steps, from the least time per step of the last three runs: other
// load on the machine makes a measured time too long, never too short.
double seconds_with(const Refinement& climb, int steps) {
  constexpr std::size_t trusted = 3;
  if (const double start = start_up(climb); start > 0.0)
    return start + std::max(0.0, climb.back().seconds.value_or(start) - start) * steps / climb.back().steps;
  double step = infinity;
  for (const RefinementRun& rung : std::span(climb).last(std::min(trusted, climb.size())))
    step = std::min(step, rung.seconds.value_or(infinity) / rung.steps);
  return step * steps;
}

int steps_of(const StepsOrTolerance& rung) {
  const auto* steps = std::get_if<int>(&rung);
  return steps != nullptr ? *steps : 0;
}

// The forecast seconds of the next run. Between tolerances the ratio of the last two times is kept.
double next_seconds(const RefinementPlan& ladder, const Refinement& climb) {
  if (const int steps = steps_of(ladder.rungs[climb.size()]); steps > 0) return seconds_with(climb, steps);
  const double last = climb.back().seconds.value_or(0.0);
  const double before = climb.size() > 1 ? climb[climb.size() - 2].seconds.value_or(last) : last;
  return before > 0.0 ? last * std::max(1.0, last / before) : last;
}

// Whether a scheme listed earlier has the same errors bit for bit at every resolution: it is the same
// algorithm on this scene.
bool is_repeated(std::span<const Refinement> of_scene, const Refinement& climb) {
  const auto same = [](const RefinementRun& rung, const RefinementRun& other) {
    return rung.steps == other.steps && rung.end.error && rung.end == other.end &&
           rung.maximum.error == other.maximum.error;
  };
  for (const Refinement& other : of_scene) {
    if (&other == &climb) return false;
    if (other.size() >= climb.size() && std::ranges::equal(climb, std::span(other).first(climb.size()), same))
      return true;
  }
  return false;
}

// Whether finer runs of this scheme cannot be the cheapest within this error.
bool is_answered(const RefinementPlan& ladder, std::span<const Refinement> of_scene, const Refinement& climb,
                 NormMember of, double error) {
  if (measured_seconds(climb, of, error)) return true;
  if (!(climb.back().*of).error || !rates_of(climb, of)) return false;
  const double own = seconds_needed(ladder, climb, of, error, true).value_or(infinity);
  if (own - start_up(climb) > ladder.goal->most_seconds) return true;
  return std::ranges::any_of(of_scene, [&](const Refinement& other) {
    if (&other == &climb || other.empty() || other.back().steps == 0) return false;
    return own > ladder.goal->margin * seconds_needed(ladder, other, of, error, false).value_or(infinity);
  });
}

// Whether more steps cannot change the cheapest run for any error of the goal, in this norm.
bool is_settled(const RefinementPlan& ladder, std::span<const Refinement> of_scene, const Refinement& climb,
                NormMember of) {
  const RefinementRun& last = climb.back();
  const auto& errors = ladder.goal->errors;
  if ((last.*of).error.value_or(infinity) <= std::ranges::min(errors) || (last.*of).at_floor) return true;
  return climb.size() >= fewest_rungs && std::ranges::all_of(errors, [&](double error) {
           return is_answered(ladder, of_scene, climb, of, error);
         });
}

// Whether for each error of the goal another scheme takes far less time than this one with adaptive step
// size.
bool is_outrun(const RefinementPlan& ladder, std::span<const Refinement> of_scene, const Refinement& climb,
               NormMember of) {
  const double last = climb.back().seconds.value_or(0.0);
  return std::ranges::all_of(ladder.goal->errors, [&](double error) {
    const double own = measured_seconds(climb, of, error).value_or(last);
    return std::ranges::any_of(of_scene, [&](const Refinement& other) {
      const auto seconds = measured_seconds(other, of, error);
      return &other != &climb && seconds && own > ladder.goal->margin * *seconds;
    });
  });
}

}  // namespace

RefinementPlan plan_for(const RefinementPlan& ladder, const Capabilities& needs) {
  RefinementPlan own;
  for (const auto& rung : ladder.rungs) {
    const bool takes = std::holds_alternative<int>(rung) ? needs.solves_on_grid : needs.takes_accuracy;
    if (takes) own.rungs.push_back(rung);
  }
  if (own.rungs.empty()) return ladder;
  own.goal = ladder.goal;
  return own;
}

RefinementRun refinement_run(const RunSettings& setup, const RecordedRun& run) {
  const auto within = [&](const char* error, const char* bound) {
    return run[error] && *run[error] <= run[bound].value_or(0.0);
  };
  const bool rounded = run["error_end"] && run["rounding_from"];
  return {
      .steps = steps_of(setup.resolution),
      .hopeless = run.ending() && is_hopeless(*run.ending()),
      .end = {run["error_end"], run["expected_rate_end"], rounded || within("error_end", "reference_bound")},
      .maximum = {run["error_maximum"], run["expected_rate_maximum"],
                  within("error_maximum", "reference_bound_maximum")},
      .seconds = run["time_minimum"],
      .wall_clock = run.wall_clock()};
}

std::optional<double> seconds_needed(const RefinementPlan& ladder, const Refinement& climb, NormMember of,
                                     double error, bool hopeful) {
  constexpr double hope = 0.5;
  if (const auto measured = measured_seconds(climb, of, error)) return measured;
  const RefinementRun& last = climb.back();
  if (!(last.*of).error || !last.seconds) return std::nullopt;
  const auto rates = rates_of(climb, of);
  if (!rates) return std::nullopt;
  const double rate = hopeful ? rates->second + hope : rates->first;
  if (rate <= 0.0) return std::nullopt;
  const double least = last.steps * std::pow(*(last.*of).error / error, 1.0 / rate);
  const auto found = std::ranges::find_if(
      ladder.rungs, [&](const auto& rung) { return steps_of(rung) > last.steps && steps_of(rung) >= least; });
  if (found == ladder.rungs.end()) return std::nullopt;
  return seconds_with(climb, steps_of(*found));
}

bool is_finished(const RefinementPlan& ladder, std::span<const Refinement> of_scene,
                 const Refinement& climb) {
  if (climb.size() == ladder.rungs.size()) return true;
  if (!ladder.goal || climb.empty()) return false;
  const RefinementRun& last = climb.back();
  if (last.hopeless) return true;
  if (last.seconds && next_seconds(ladder, climb) - start_up(climb) > ladder.goal->most_seconds) return true;
  if (last.steps == 0) {
    return climb.size() >= fewest_accuracies && is_outrun(ladder, of_scene, climb, &RefinementRun::end) &&
           is_outrun(ladder, of_scene, climb, &RefinementRun::maximum);
  }
  if (climb.size() >= fewest_rungs && is_repeated(of_scene, climb)) return true;
  return is_settled(ladder, of_scene, climb, &RefinementRun::end) &&
         is_settled(ladder, of_scene, climb, &RefinementRun::maximum);
}

}  // namespace fde
