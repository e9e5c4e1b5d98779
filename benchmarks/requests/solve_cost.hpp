// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {

// What a run has spent on the states that it kept in a file.
struct CheckpointCost {
  bool continued = false;  // from a state of an earlier run
  std::int64_t count = 0;
  std::uintmax_t bytes = 0;  // of the last state
  double seconds = 0.0;      // of all writes
};

// What a run took, and what theory expects of it.
struct SolveCost {
  double seconds = 0.0;
  Cost of_scheme{};    // without the kind of history where there is no grid
  std::string grid{};  // that optimal_grading() chose; empty: it was not asked
  std::optional<CheckpointCost> checkpoints{};
  std::optional<double> expected_rate{};  // at the end, of a run over a grid
};

}  // namespace fde::bench
