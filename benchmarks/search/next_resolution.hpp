// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "fdebench/benchmarks/search/refinement.hpp"

namespace fde::bench {

// What a search for the cheapest runs asks, and how far it goes.
struct SearchGoal {
  std::vector<ErrorTarget> targets{};  // of each the cheapest run is wanted
  int coarsest_steps = 4;              // of the first run over a grid
  std::size_t fewest_runs = 1;         // of a configuration, before it is left for being slow
  int most_steps = 1 << 29;
  double loosest = 0.1, tightest = 1e-15;  // tolerances of adaptive step size
  double most_seconds = 0.3;               // of a solve; slower runs are not made
  // A configuration is left once its runs outside a target take this multiple of the quickest run within it.
  double margin = 1.5;
  // Seconds; longer runs are made only where a forecast expects something of them. Over grids, where errors
  // follow their rate, forecasts hold from shorter runs on.
  double long_run = 5e-3, long_run_over_grid = 5e-3;
  double short_run = 5e-5;   // seconds; shorter runs are not put off for shorter ones
  int binary_digits = 31;    // significant ones of numbers of steps: runs with few share comparison times
  double closeness = 1.015;  // ratio of the fewest steps within a target and the most outside it
  // Scans for runs with fewer steps where the error need not decrease with the steps, while a run takes at
  // most this many seconds.
  double most_seconds_scanned = 0.0;
};

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
// in log N and log e. Tolerances are divided by ten from the loosest on; then those next to the quickest run
// are tried, for neither error nor time need be monotone in the tolerance. A configuration is left
//   - if more steps fail alike, or another run would take more than most_seconds;
//   - if its finest run, not within the target, already takes `margin` times the quickest run within it; a
//     run that failed counts with the cheapest step of any configuration;
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
