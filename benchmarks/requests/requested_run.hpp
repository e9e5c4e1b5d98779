// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/benchmarks/requests/solve_request.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// A request that its scheme accepts for a scene, with what follows from both.
struct RequestedRun {
  const Scheme& scheme;
  RunSettings settings;  // with the grading that is taken
  Resolution resolution;
  std::optional<Grid> grid;   // nullopt: adaptive step size
  std::vector<double> times;  // output times; empty: all
  Options options;            // without the output times
  bool keeps_columns;         // needs no states: the columns at the output times are enough
};

// Throws Refusal naming the field, its value and what is allowed.
RequestedRun requested_run(const Scene& scene, const SolveRequest& request);

}  // namespace fde::bench
