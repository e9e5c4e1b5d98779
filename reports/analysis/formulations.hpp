#pragma once

#include <string>
#include <vector>

#include "analysis/runs.hpp"

namespace fde {

// The runs of one scene in one formulation that have a drift: also those that came to their end without a
// reference to compare with.
struct FormulationRuns {
  std::string formulation;  // empty: the scene has no choice of it
  std::vector<MeasuredRun> runs{};
};

// A scene in all its formulations, which its settings do not name.
struct ConstrainedScene {
  SceneSettings scene;
  std::vector<FormulationRuns> formulations{};
  int steps = 0;  // the finest step count that all lines have; 0: there is none
};

// In the order of the runs; the formulation that is a scene's default first.
std::vector<ConstrainedScene> constrained_scenes(const Runs& runs);

// The drift that a run is judged by: the independent one, or the internal one where there is no other.
double judged_drift(const MeasuredRun& run);

// Drifts below are rounding, and all the same.
inline constexpr double drift_of_rounding = 1e-12;

// A formulation's run with the least drift among those that take at most a given time, in seconds; of those
// at rounding the one with the least error.
struct BestInTime {
  std::string formulation;
  MeasuredRun run;
};

// Such runs within the largest time that every formulation was given, the least drift and error first. Empty
// where fewer than two formulations were timed.
struct BestInTimes {
  double seconds = 0.0;
  std::vector<BestInTime> ranked{};
};
BestInTimes best_in_time(const ConstrainedScene& scene);

}  // namespace fde
