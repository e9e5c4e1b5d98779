#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "observers/drift.hpp"
#include "scenes/scene.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// One finished run with all that a measure may look at. Rows hold the scene's columns as rows, one column a
// time of watched_times; reference has none where there is no reference.
struct Observation {
  const Scene& scene;
  const Scheme& scheme;
  const Trajectory& path;
  const Rows& values;
  const Rows& reference;  // no columns where there is no reference
  const Vec&
      reference_bound;   // of the reference at the end: a bound, or an estimate where that is all there is
  Rows rounded{};        // the same values with other rounding; no columns where that run did not finish
  double grading = 1.0;  // of the grid
  std::optional<double> energy_residual{};                     // EnergyBalance, which saw every step
  std::optional<Drift> internal_drift{}, independent_drift{};  // DriftWatch, which saw every step
};

// One number taken from a run. Where it does not apply it is not computed and has no row.
struct Measure {
  std::string_view id, unit;
  bool (*applies)(const Observation&);
  double (*value)(const Observation&);
};

std::span<const Measure> measures();

// The same for the times of repeated solves, in seconds.
struct TimeMeasure {
  std::string_view id;
  double (*value)(const std::vector<double>& seconds);
};
std::span<const TimeMeasure> time_measures();

// max_i |y_i - reference_i| at the last step; over all watched steps.
double error_end(const Observation& run);
double error_maximum(const Observation& run);

// -log10 max_i |y_i - reference_i| / (1 + |reference_i|) at the last step: the significant digits of the IVP
// test set (Bari) and FDE-Testset (Brugnano et al. 2025). At most 17, where the two are equal.
double mescd(const Observation& run);

}  // namespace fde
