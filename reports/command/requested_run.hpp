// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reports/command/arguments.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// The options of `solve` for a run, as texts. --until is part of the scene.
struct RunArguments {
  std::string scheme;
  std::optional<std::string> steps, accuracy, at, every, points, threads, checkpoint, checkpoint_every, field;
  RunSettingsArguments settings{.budget = "3600"};
  bool check = false;
  bool events = false;  // print the events instead of output times
  bool all = false;     // all solutions that a search finds, of a problem at both ends
};

// The arguments of a run whose options are given by their names without dashes, "check" as "1" or "0". Throws
// std::invalid_argument for another name.
RunArguments run_arguments(const std::string& scheme, const std::map<std::string, std::string>& texts);

// What --every and --points, --threads and --checkpoint-every may be.
inline constexpr int most_rows = 10'000'000;
inline constexpr CountRange point_counts{2, most_rows}, thread_counts{1, 1024};
constexpr double usual_seconds_between_checkpoints = 300.0;

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
RequestedRun requested_run(const Scene& scene, const RunArguments& arguments);

}  // namespace fde::bench
