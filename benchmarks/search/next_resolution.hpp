// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "fdebench/benchmarks/search/search_goal.hpp"

namespace fde::bench {

// The seconds of the quickest run of all configurations within each target; infinity where there is none.
std::vector<double> quickest_seconds(const SearchGoal& goal, std::span<const Refinement> of_scene);

// Forecasts of the configurations of one scene, by the number of the configuration, its number of runs and
// the kind of error; then by the error.
struct ConfigurationForecast {
  ErrorModel model;
  std::map<double, std::optional<Prediction>> seconds{};
};
using ForecastMemo = std::map<std::tuple<std::size_t, std::size_t, std::size_t>, ConfigurationForecast>;

// The next run of each configuration of a scene that can change which run is the cheapest within some target;
// nullopt where there is none. The steps are doubled, from coarsest_steps on, until a run is within the
// target; then the bracket between the fewest steps within it and the most outside it is closed by the secant
// in log N and log e. Tolerances are divided by ten from the loosest on, by up to a thousand before runs
// longer than long_run where the errors so far leave the target that far away; then those next to the
// quickest run are tried, for neither error nor time need be monotone in the tolerance. A configuration is
// left
//   - if more steps fail alike, or another run would take more than most_seconds;
//   - if its finest run, not within the target, already takes `margin` times the quickest run within it; a
//     run that failed counts with the cheapest step of any configuration, or with its time where it grew
//     beyond all numbers;
//   - if its errors stagnate outside the target;
//   - if by its errors so far, which decrease, it needs more than `margin` times what another one is measured
//     or forecast to need; this is asked only before runs that take longer than long_run, and where no run is
//     left that may reach a target that none has reached, it may need as long as most_seconds;
//   - if it is the same algorithm as one listed before.
// A function of the runs alone: a sweep that is continued, or told of better times, goes on from the runs.
// `memo`: of the same configurations, whose runs have only become more since an earlier call.
std::vector<std::optional<StepsOrTolerance>> next_resolutions(const SearchGoal& goal,
                                                              std::span<const Refinement> of_scene,
                                                              ForecastMemo& memo);
std::vector<std::optional<StepsOrTolerance>> next_resolutions(const SearchGoal& goal,
                                                              std::span<const Refinement> of_scene);

// The numbers of the configurations whose next run takes about as long as the shortest of these runs: longer
// ones may be needless once these have shown the quickest run within a target.
std::vector<std::size_t> due_runs(const SearchGoal& goal, std::span<const Refinement> of_scene,
                                  std::span<const std::optional<StepsOrTolerance>> next);

}  // namespace fde::bench
