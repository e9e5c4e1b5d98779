// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// The runs of one scene in one formulation for which the drift was measured, runs without a reference
// included.
struct FormulationRuns {
  std::string formulation;  // empty: the scene has one formulation only
  std::vector<Record> runs{};
};

// A scene in all its formulations.
struct ConstrainedScene {
  SceneSettings scene;  // without the formulation
  std::vector<FormulationRuns> formulations{};
  int steps = 0;  // the largest number of steps common to all lines; 0: there is none
};

// The scenes with a drift, in the order of the runs; the default formulation of a scene first.
std::vector<ConstrainedScene> constrained_scenes(const Runs& runs);

// The independent drift of a run, or the internal one if the independent one was not measured; 0 if neither
// was.
double effective_drift(const Record& run);

// Drifts below this are rounding and compare as equal.
inline constexpr double rounding_drift = 1e-12;

// The run of a formulation with the least drift within a time limit; among drifts of rounding, the least
// error.
struct BestInTime {
  std::string formulation;
  Record run;
};

// The best run of each formulation within `seconds`, the longest time up to which every formulation has runs;
// the least drift and error first. Empty if fewer than two formulations have times.
struct BestInTimes {
  double seconds = 0.0;
  std::vector<BestInTime> ranked{};
};
BestInTimes best_in_time(const ConstrainedScene& scene);

}  // namespace fde::bench
