// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/fit/goodness.hpp"
#include "fdebench/benchmarks/records/external_trajectory.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

// What is asked of judge().
struct JudgeRequest {
  SceneVariant variant;
  std::function<ExternalTrajectory(const Scene& scene)> trajectory;  // called once the rest is accepted
  std::optional<std::string> name{};  // of the other program; results files need one
  std::vector<double> seconds{};      // durations of its solves; empty: those that it reports
};

// A trajectory of another program, compared with the reference of its scene.
struct JudgedTrajectory {
  Record run{};                                     // its scene ends with the trajectory
  std::function<SceneDescription()> description{};  // of that scene, computed at each call
  // Of measurements with standard deviations, where all values are finite.
  std::optional<ChiSquared> chi_squared{};
};

// Throws Refusal naming the field: a name that no other program may have, seconds that are not above 0, a
// trajectory that ends before a scene posed at both ends.
JudgedTrajectory judge(const JudgeRequest& request);

}  // namespace fde::bench
