#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene.hpp"
#include "scheme.hpp"

namespace fde {

// One finished run with all that a measure may look at. Rows hold the scene's columns as rows, one column a
// step.
struct Observation {
  const Scene& scene;
  const Scheme& scheme;
  const Options& options;
  const Trajectory& path;
  const Rows& values;
  const Rows& truth;
  double truth_bound;  // of the truth at the end: a bound, or an estimate where that is all there is
  const std::vector<double>& seconds;  // of the solve alone, one a repeat
};

// One number taken from a run. Where it does not apply it is not computed and has no row.
struct Measure {
  std::string_view id, unit;
  bool (*applies)(const Observation&);
  double (*value)(const Observation&);
};

std::span<const Measure> measures();

// max_i |y_i - truth_i| at the last step; over all steps.
double error_end(const Observation& run);
double error_maximum(const Observation& run);

// -log10 max_i |y_i - truth_i| / (1 + |truth_i|) at the last step: the significant digits of the IVP test set
// (Bari) and FDE-Testset (Brugnano et al. 2025). At most 17, where the two are equal.
double mescd(const Observation& run);

// max_n |E(t_n) - E(0) - int_0^(t_n) power dt|, the integral by GSL's cubic spline through all steps.
double energy_residual(const Observation& run);

}  // namespace fde
