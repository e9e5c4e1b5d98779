// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/refinement_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace fde::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t fewest_runs = 5, fewest_accuracies = 3;

bool is_hopeless(const OutcomeKind& kind) {
  const std::array hopeless{OutcomeKind(SolveStatus::refused),       OutcomeKind(SolveStatus::left_domain),
                            OutcomeKind(SolveStatus::out_of_budget), OutcomeKind(Verdict::no_reference),
                            OutcomeKind(Verdict::overflow),          OutcomeKind(Verdict::passed_singularity),
                            OutcomeKind(Verdict::program_failed)};
  return std::ranges::find(hopeless, kind) != hopeless.end();
}

// The observed rate of the last two runs and the theoretical rate, the smaller first.
std::optional<std::pair<double, double>> rates_of(const Refinement& refinement, NormMember of) {
  const RefinementRun& last = refinement.back();
  if (last.steps == 0) return std::nullopt;
  std::vector<double> rates;
  if ((last.*of).rate) rates.push_back(*(last.*of).rate);
  if (refinement.size() > 1 && (refinement[refinement.size() - 2].*of).error.value_or(0.0) > 0.0) {
    const RefinementRun& before = refinement[refinement.size() - 2];
    rates.push_back(std::log(*(before.*of).error / *(last.*of).error) /
                    std::log(static_cast<double>(last.steps) / before.steps));
  }
  if (rates.empty()) return std::nullopt;
  return std::minmax({rates.front(), rates.back()});
}

std::optional<double> measured_seconds(const Refinement& refinement, NormMember of, double error) {
  double least = infinity;
  for (const RefinementRun& run : refinement) {
    if ((run.*of).error.value_or(infinity) <= error) least = std::min(least, run.seconds.value_or(infinity));
  }
  return least < infinity ? std::optional(least) : std::nullopt;
}

// The time to start a process: the time of the first run, 0 unless times are of whole processes.
double start_up(const Refinement& refinement) {
  return refinement.back().wall_clock ? refinement.front().seconds.value_or(0.0) : 0.0;
}

// The forecast seconds for this number of steps, from the least time per step of the last three runs: other
// load on the machine makes a measured time too long, never too short.
double seconds_with(const Refinement& refinement, int steps) {
  constexpr std::size_t trusted = 3;
  if (const double start = start_up(refinement); start > 0.0) {
    return start +
           std::max(0.0, refinement.back().seconds.value_or(start) - start) * steps / refinement.back().steps;
  }
  double step = infinity;
  for (const RefinementRun& run : std::span(refinement).last(std::min(trusted, refinement.size())))
    step = std::min(step, run.seconds.value_or(infinity) / run.steps);
  return step * steps;
}

int steps_of(const StepsOrTolerance& resolution) {
  const auto* steps = std::get_if<int>(&resolution);
  return steps != nullptr ? *steps : 0;
}

// The forecast seconds of the next run. Between tolerances the ratio of the last two times is kept.
double next_seconds(const RefinementPlan& plan, const Refinement& refinement) {
  if (const int steps = steps_of(plan.resolutions[refinement.size()]); steps > 0)
    return seconds_with(refinement, steps);
  const double last = refinement.back().seconds.value_or(0.0);
  const double before =
      refinement.size() > 1 ? refinement[refinement.size() - 2].seconds.value_or(last) : last;
  return before > 0.0 ? last * std::max(1.0, last / before) : last;
}

// Whether a scheme listed earlier has the same errors bit for bit at every resolution: it is the same
// algorithm on this scene.
bool is_repeated(std::span<const Refinement> of_scene, const Refinement& refinement) {
  const auto same = [](const RefinementRun& run, const RefinementRun& other) {
    return run.steps == other.steps && run.end.error && run.end == other.end &&
           run.maximum.error == other.maximum.error;
  };
  for (const Refinement& other : of_scene) {
    if (&other == &refinement) return false;
    if (other.size() >= refinement.size() &&
        std::ranges::equal(refinement, std::span(other).first(refinement.size()), same))
      return true;
  }
  return false;
}

// Whether finer runs of this scheme cannot be the cheapest within this error.
bool is_answered(const RefinementPlan& plan, std::span<const Refinement> of_scene,
                 const Refinement& refinement, NormMember of, double error) {
  if (measured_seconds(refinement, of, error)) return true;
  if (!(refinement.back().*of).error || !rates_of(refinement, of)) return false;
  const double own = seconds_needed(plan, refinement, of, error, true).value_or(infinity);
  if (own - start_up(refinement) > plan.goal->most_seconds) return true;
  return std::ranges::any_of(of_scene, [&](const Refinement& other) {
    if (&other == &refinement || other.empty() || other.back().steps == 0) return false;
    return own > plan.goal->margin * seconds_needed(plan, other, of, error, false).value_or(infinity);
  });
}

// Whether more steps cannot change the cheapest run for any error of the goal, in this norm.
bool is_settled(const RefinementPlan& plan, std::span<const Refinement> of_scene,
                const Refinement& refinement, NormMember of) {
  const RefinementRun& last = refinement.back();
  const auto& errors = plan.goal->errors;
  if ((last.*of).error.value_or(infinity) <= std::ranges::min(errors) || (last.*of).is_stagnant) return true;
  return refinement.size() >= fewest_runs && std::ranges::all_of(errors, [&](double error) {
           return is_answered(plan, of_scene, refinement, of, error);
         });
}

// Whether for each error of the goal another scheme takes far less time than this one with adaptive step
// size.
bool is_overtaken(const RefinementPlan& plan, std::span<const Refinement> of_scene,
                  const Refinement& refinement, NormMember of) {
  const double last = refinement.back().seconds.value_or(0.0);
  return std::ranges::all_of(plan.goal->errors, [&](double error) {
    const double own = measured_seconds(refinement, of, error).value_or(last);
    return std::ranges::any_of(of_scene, [&](const Refinement& other) {
      const auto seconds = measured_seconds(other, of, error);
      return &other != &refinement && seconds && own > plan.goal->margin * *seconds;
    });
  });
}

}  // namespace

RefinementPlan plan_for(const RefinementPlan& plan, const Capabilities& capabilities) {
  RefinementPlan own;
  for (const auto& resolution : plan.resolutions) {
    const bool takes = std::holds_alternative<int>(resolution) != capabilities.is_adaptive();
    if (takes) own.resolutions.push_back(resolution);
  }
  if (own.resolutions.empty()) return plan;
  own.goal = plan.goal;
  return own;
}

RefinementRun refinement_run(const RunSettings& setup, const RecordedRun& run) {
  const auto within = [&](const char* error, const char* bound) {
    return run[error] && *run[error] <= run[bound].value_or(0.0);
  };
  const bool rounded = run["error_end"] && run["rounding_from"];
  return {
      .steps = steps_of(setup.resolution),
      .fails_with_more_steps = run.ending() && is_hopeless(*run.ending()),
      .end = {run["error_end"], run["expected_rate_end"], rounded || within("error_end", "reference_bound")},
      .maximum = {run["error_maximum"], run["expected_rate_maximum"],
                  within("error_maximum", "reference_bound_maximum")},
      .seconds = run["time_minimum"],
      .wall_clock = run.wall_clock()};
}

std::optional<double> seconds_needed(const RefinementPlan& plan, const Refinement& refinement, NormMember of,
                                     double error, bool hopeful) {
  constexpr double hope = 0.5;
  if (const auto measured = measured_seconds(refinement, of, error)) return measured;
  const RefinementRun& last = refinement.back();
  if (!(last.*of).error || !last.seconds) return std::nullopt;
  const auto rates = rates_of(refinement, of);
  if (!rates) return std::nullopt;
  const double rate = hopeful ? rates->second + hope : rates->first;
  if (rate <= 0.0) return std::nullopt;
  const double least = last.steps * std::pow(*(last.*of).error / error, 1.0 / rate);
  const auto found = std::ranges::find_if(plan.resolutions, [&](const auto& resolution) {
    return steps_of(resolution) > last.steps && steps_of(resolution) >= least;
  });
  if (found == plan.resolutions.end()) return std::nullopt;
  return seconds_with(refinement, steps_of(*found));
}

bool is_finished(const RefinementPlan& plan, std::span<const Refinement> of_scene,
                 const Refinement& refinement) {
  if (refinement.size() == plan.resolutions.size()) return true;
  if (!plan.goal || refinement.empty()) return false;
  const RefinementRun& last = refinement.back();
  if (last.fails_with_more_steps) return true;
  if (last.seconds && next_seconds(plan, refinement) - start_up(refinement) > plan.goal->most_seconds)
    return true;
  if (last.steps == 0) {
    return refinement.size() >= fewest_accuracies &&
           is_overtaken(plan, of_scene, refinement, &RefinementRun::end) &&
           is_overtaken(plan, of_scene, refinement, &RefinementRun::maximum);
  }
  if (refinement.size() >= fewest_runs && is_repeated(of_scene, refinement)) return true;
  return is_settled(plan, of_scene, refinement, &RefinementRun::end) &&
         is_settled(plan, of_scene, refinement, &RefinementRun::maximum);
}

}  // namespace fde::bench
