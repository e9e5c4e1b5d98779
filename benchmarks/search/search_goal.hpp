// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
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
  // Seconds after which a run with a tolerance is ended. One that was ended is made again while no run is
  // within the target, once it may take clearly longer.
  double budget_of_tolerance = 0.0;
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

// The next run of a configuration; nullopt: none.
using NextRun = std::optional<StepsOrTolerance>;

// A configuration can be the cheapest only while its runs outside the target take less than this multiple of
// the quickest run within it; measured times differ by some percent.
inline constexpr double near_quickest = 1.2;

// The part of most_seconds up to which the first runs of a configuration, fewest_runs of them, are made.
inline constexpr double early_part = 0.1;

// Whether a configuration cannot be the cheapest, asked before a run that takes so many seconds.
using IsOutOfReach = std::function<bool(double next_seconds)>;

}  // namespace fde::bench
