// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/study/study.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "fdebench/reports/command/arguments.hpp"

namespace fde::bench {

// The options of `run`, as texts.
inline constexpr CountRange repeat_counts{1, 1000};

struct SweepArguments {
  std::vector<std::string> scenes, settings, schemes, externals;
  std::optional<std::string> steps, accuracies;
  RunSettingsArguments means = usual_settings();
  std::string repeats = "3";
  std::optional<std::string> out;
  std::optional<std::string> shard;
  std::optional<std::string> study;
  bool trials = false, thorough = false, dry_run = false, examine = false, undisturbed = false;

 private:
  static RunSettingsArguments usual_settings();
};

// The requested sweep. With --trials the trials only; without scenes and steps the trials as well. With
// --study the sweeps of the study, or of the shard of it. Throws std::invalid_argument naming the argument,
// the text and what is allowed.
std::vector<Sweep> sweeps_of(const SweepArguments& arguments, const SceneRegistry& known);

// One sweep for all families with the same settings, in the order of the file. Results do without the
// solutions of scenes. Throws std::invalid_argument naming file, line and column, the key, its value and what
// is allowed.
std::vector<Sweep> sweeps_of(const Study& study);

// Whether the forecast number of runs is exact: with a goal the refinement may end elsewhere than forecast.
bool count_is_exact(const std::vector<Sweep>& sweeps);

}  // namespace fde::bench
