// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// A run at one value of the parameter.
struct CurvePoint {
  double value = 0.0;
  const Record* run = nullptr;
};

// The runs of scenes that differ in one parameter, all with the same number of steps: the largest that every
// line has at all its values of the parameter.
struct ParameterCurves {
  SceneSettings scene;    // the common settings
  std::string parameter;  // or "until" for the end time
  int steps = 0;
  std::vector<CurvePoint> points{};  // by increasing value; within a scene in the order of the lines
};

// One element for each parameter with at least three values; lines with fewer values are left out. A scene
// without a value has the default of the parameter. `runs` must outlive the result.
inline constexpr std::size_t fewest_values = 3;
std::vector<ParameterCurves> parameter_curves(const Runs& runs);

}  // namespace fde::bench
