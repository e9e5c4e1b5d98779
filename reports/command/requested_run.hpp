// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reports/command/given.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

inline constexpr int most_rows = 10'000'000;

// The options of `solve` by their names without dashes, "check" as "1" or "0". Throws std::invalid_argument
// for another name.
Given given_to_solve(const std::string& scheme, const std::map<std::string, std::string>& texts);

// The parsed options: one run, accepted by its scheme.
struct RequestedRun {
  const Scheme& scheme;
  RunSettings setup;
  Resolution resolution;
  std::optional<Grid> grid;      // nullopt: adaptive step size
  std::vector<double> times;     // output times; empty: all
  Options options;               // without the output times
  bool stores_states = false;    // stores the states at the output times, for --field
  std::string automatic_grid{};  // the grid chosen by graded:auto; empty without graded:auto
};

// Throws std::invalid_argument naming the argument, the text and what is allowed.
RequestedRun requested_run(const Scene& scene, const Given& given);

}  // namespace fde::bench
