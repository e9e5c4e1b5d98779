#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "observers/drift.hpp"
#include "scenes/scene.hpp"
#include "stepping/trajectory.hpp"

namespace fde {

// What a trajectory does not tell of itself. All of it may be absent: nobody knows it of a trajectory that
// another program wrote.
struct Observed {
  std::optional<Grid> grid{};  // over which it was stepped
  Rows rounded{};              // the scene's columns with other rounding, one column a time of the trajectory
  std::optional<double> energy_residual{};                             // by an EnergyObserver
  std::optional<Drift> internal_drift{}, independent_drift{};          // by a DriftObserver
  std::optional<double> expected_rate_end{}, expected_rate_maximum{};  // of the scheme
};

// One finished run with all that a measure may look at. Rows hold the scene's columns as rows, one column a
// time of the trajectory.
struct FinishedRun {
  const Trajectory& path;
  const Rows& values;
  const Rows& reference;         // no columns where there is no reference
  const Rows& reference_bounds;  // of the same values: bounds, or estimates where that is all there is
  const Observed& observed;
};

// One number taken from a run; nullopt where it does not apply. A new measure is one file, which defines its
// row, and one line of list.def.
struct Measure {
  std::string_view id, unit;
  std::optional<double> (*value)(const FinishedRun&);
};

namespace measure {

#define FDE_MEASURE(id) extern const Measure id;
#include "measures/list.def"
#undef FDE_MEASURE

}  // namespace measure

// All of them, in the order of list.def.
std::span<const Measure* const> measures();

// The same for the times of repeated solves, in seconds.
struct TimeMeasure {
  std::string_view id;
  double (*value)(const std::vector<double>& seconds);
};
std::span<const TimeMeasure> time_measures();

// A measured number.
struct Measured {
  std::string_view id, unit;
  double value;
};

// -log10 max_i |y_i - reference_i| / (1 + |reference_i|) at the last time: the significant digits of the IVP
// test set (Bari) and FDE-Testset (Brugnano et al. 2025). At most 17, where the two are equal.
double mescd(const Rows& values, const Rows& reference);

}  // namespace fde
