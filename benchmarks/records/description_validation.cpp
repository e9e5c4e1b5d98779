// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "fdebench/benchmarks/records/record_validation.hpp"
#include "fdebench/benchmarks/records/well_formed.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {
namespace {

void require_columns(const SampledColumns& columns, const std::vector<double>& t) {
  require_length("solution", columns.values.size(), columns.names.size());
  for (const auto& name : columns.names) require_name("solution", name);
  for (const auto& values : columns.values) {
    require_length("solution", values.size(), t.size());
    for (const auto& value : values) {
      if (value) require_in("solution", *value, any_number);
    }
  }
}

// Two or three coordinates, columns of the scene or with values of their own.
void require_motion(const SampledColumns& motion, const SampledSolution& solution) {
  if (motion.names.size() < 2 || motion.names.size() > 3)
    reject_text("motion", fmt::format("{} columns", motion.names.size()), "2 or 3 columns");
  if (!motion.values.empty()) return require_columns(motion, solution.t);
  for (const auto& name : motion.names) {
    if (std::ranges::find(solution.columns.names, name) == solution.columns.names.end())
      reject_text("motion", name, "a column of the solution, or have values");
  }
}

void require_solution(const SampledSolution& solution) {
  require_times("solution", solution.t);
  require_in("bound", solution.bound, not_negative);
  if (solution.t.empty() || solution.columns.names.empty())
    throw std::invalid_argument("solution: must have a time and a column");
  for (const auto* part : {&solution.columns, &solution.energy, &solution.reactions})
    require_columns(*part, solution.t);
  if (!solution.motion.names.empty()) require_motion(solution.motion, solution);
}

void require_trial(const TrialRuns& trial) {
  require_name("trial", trial.kind);
  require_in("trial", trial.number, not_negative);
  require_in("trial", trial.steps, {.low = 1.0});
  require_in("trial", trial.accuracy.rtol, not_negative);
  require_in("trial", trial.accuracy.atol, not_negative);
}

}  // namespace

void require_valid(const SceneDescription& scene) {
  require_scene(scene.scene);
  require_printable("title", scene.title);
  require_printable("source", scene.source);
  require_printable("evidence", scene.evidence);
  for (const auto& [left, right] : scene.equations) {
    require_printable("equations", left);
    require_printable("equations", right);
  }
  for (const auto& parameter : scene.parameters) {
    require_name("parameters", parameter.name);
    require_printable(parameter.name, parameter.value);
    require_printable(parameter.name, parameter.meaning);
  }
  for (const auto& [parameter, limit] : scene.discontinuities) {
    require_name("discontinuities", parameter);
    require_printable(parameter, limit);
  }
  if (scene.reference_seconds) require_in("reference_seconds", *scene.reference_seconds, not_negative);
  if (scene.trial) require_trial(*scene.trial);
  if (scene.solution) require_solution(*scene.solution);
}

}  // namespace fde::bench
