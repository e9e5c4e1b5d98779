// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/measures/own_measure.hpp"
#include "fdebench/benchmarks/measures/timing_conditions.hpp"
#include "fdebench/benchmarks/observers/drift.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {

// Data about a run that its trajectory does not contain. Everything is optional; for a trajectory of another
// program everything is absent.
struct RunObservations {
  std::optional<Grid> grid{};  // the grid of the steps
  Rows rounded{};  // the columns of the scene with different rounding (rounding.hpp), one column a time of
                   // the trajectory
  std::optional<double> energy_residual{};                             // from EnergyObserver
  std::optional<Drift> internal_drift{}, independent_drift{};          // from DriftObserver
  std::optional<double> expected_rate_end{}, expected_rate_maximum{};  // of the scheme
  std::array<Vec, error_scales.size()> unresolved{};                   // unresolved_variations(), by Scale
  std::span<const OwnMeasure> own{};                                   // are taken after ours
};

// A finished run with the arguments of all measures. Rows have one row a column of the scene, one column a
// time of the trajectory.
struct FinishedRun {
  const Trajectory& path;
  const Rows& values;
  const Rows& reference;         // without columns if there is no reference
  const Rows& reference_bounds;  // bounds of the error of the reference, or estimates
  const RunObservations& observed;
  ErrorTable errors = error_table(path.times, values, reference);
};

// A number computed from a run; nullopt if it does not apply. To add a measure, define its row in one file
// and add one line to list.def.
struct Measure {
  std::string_view id, unit{};
  std::optional<double> (*value)(const FinishedRun&);
  bool may_be_negative = false;  // a size, a time or a count is not
  // Its largest value up to t, if that is recorded too.
  Course (*course)(const FinishedRun&) = nullptr;
  // Of an error: its norm and scale, by which `compare` bounds its uncertainty.
  std::optional<ErrorKind> error{};
};

namespace measure {

#define FDE_MEASURE(id) extern const Measure id;
#include "fdebench/benchmarks/measures/list.def"
#undef FDE_MEASURE

}  // namespace measure

// The errors of all kinds and their baselines, then those of list.def in its order.
std::span<const Measure* const> measures();

// The seconds of repeated solves, and by how much the first run of a process takes longer (SetupTime). The
// thread did not run for `waited` seconds of each solve.
struct TimedSolves {
  std::vector<double> seconds{}, waited{};
  double setup_seconds = 0.0;
  std::optional<double> start_seconds{};  // of the process of another program, besides its solves
  std::optional<TimingConditions> conditions{};
};

// Measures of the times of repeated solves and of what disturbed them; nullopt where one does not apply.
struct TimeMeasure {
  std::string_view id;
  std::optional<double> (*value)(const TimedSolves& timed);
  std::string_view unit = "s";
};
std::span<const TimeMeasure> time_measures();

// Whether other work on the machine made the times longer: the median solve waited for the processor, or took
// much longer than the quickest. docs/cluster.md says how often this is right.
bool is_disturbed(const TimedSolves& timed);

// A measured number.
struct MeasuredValue {
  std::string_view id, unit;
  double value;
  Course course{};  // its largest value up to t; empty: not recorded
};

// -log10 max_i |y_i - reference_i| / (1 + |reference_i|) at the last time: the significant digits of the IVP
// test set (Bari) and FDE-Testset (Brugnano et al. 2025). At most 17, also if the two are equal.
double mescd(const Rows& values, const Rows& reference);

}  // namespace fde::bench
