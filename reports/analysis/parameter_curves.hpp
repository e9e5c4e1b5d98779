#pragma once

#include <string>
#include <vector>

#include "analysis/runs.hpp"

namespace fde {

// A run at a value of the parameter.
struct CurvePoint {
  double value = 0.0;
  const MeasuredRun* run = nullptr;
};

// The runs of scenes that differ in one number only, with the same number of steps: the largest that each
// line has at all values at which it has runs.
struct ParameterCurves {
  SceneSettings scene;    // what they share
  std::string parameter;  // or "until", of their ends
  int steps = 0;
  std::vector<CurvePoint> points{};  // the values increase, those of one scene keep the order of the lines
};

// One for each parameter that has at least three values; lines with fewer are left out. A scene that does not
// say it has the default of its parameter. The runs have to live as long.
inline constexpr std::size_t fewest_values = 3;
std::vector<ParameterCurves> parameter_curves(const Runs& runs);

}  // namespace fde
