// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/formulations.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "fdebench/reports/analysis/scene_numbers.hpp"

namespace fde::bench {
namespace {

constexpr auto choice_of_form = "formulation";

// The formulation in the settings of a scene, or the default; empty if the scene has one formulation only or
// is not described.
std::string formulation_of(const Runs& runs, const SceneSettings& scene) {
  const auto said = scene.values.find(choice_of_form);
  if (said != scene.values.end()) {
    const auto* word = std::get_if<std::string>(&said->second);
    return word == nullptr ? "" : *word;
  }
  const auto* described = runs.describe(scene);
  if (described == nullptr) return {};
  const auto& parameters = described->parameters;
  const auto found = std::ranges::find(parameters, choice_of_form, &DescribedParameter::name);
  return found == parameters.end() ? "" : found->value;
}

template <class Items, class Name, class Value>
auto& named(Items& items, Name name, const Value& value) {
  const auto found = std::ranges::find(items, value, name);
  if (found != items.end()) return *found;
  items.push_back({value});
  return items.back();
}

int finest_common(const ConstrainedScene& scene) {
  std::vector<RunSpan> lines;
  for (const auto& formulation : scene.formulations) {
    for (const RunSpan line : by_line(formulation.runs)) lines.push_back(line);
  }
  int finest = 0;
  for (const Record& run : lines.front()) {
    const bool common = std::ranges::all_of(lines, [&](RunSpan line) {
      return std::ranges::find(line, run.steps, &Record::steps) != line.end();
    });
    if (common) finest = std::max(finest, run.steps);
  }
  return finest;
}

// Sort key of runs: drift, then error.
std::pair<double, double> rank_of(const Record& run) {
  return {std::max(effective_drift(run), rounding_drift),
          run["error_end"].value_or(std::numeric_limits<double>::infinity())};
}

double seconds_of(const Record& run) {
  return run["time_minimum"].value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

std::vector<ConstrainedScene> constrained_scenes(const Runs& runs) {
  std::vector<ConstrainedScene> scenes;
  for (const auto* some : {&runs.finished, &runs.failed}) {
    for (const Record& run : *some) {
      if (!run["drift_internal"]) continue;
      const SceneSettings& scene = run.key.scene;
      auto& of = named(scenes, &ConstrainedScene::scene, without(scene, choice_of_form)).formulations;
      named(of, &FormulationRuns::formulation, formulation_of(runs, scene)).runs.push_back(run);
    }
  }
  for (auto& scene : scenes) scene.steps = finest_common(scene);
  return scenes;
}

double effective_drift(const Record& run) {
  const auto independent = run["drift_independent"];
  return independent ? *independent : run["drift_internal"].value_or(0.0);
}

BestInTimes best_in_time(const ConstrainedScene& scene) {
  BestInTimes best{.seconds = std::numeric_limits<double>::infinity()};
  if (scene.formulations.size() < 2) return {};
  for (const auto& formulation : scene.formulations) {
    double longest = 0.0;
    for (const auto& run : formulation.runs) longest = std::max(longest, run["time_minimum"].value_or(0.0));
    if (longest == 0.0) return {};
    best.seconds = std::min(best.seconds, longest);
  }
  for (const auto& formulation : scene.formulations) {
    const Record* least = nullptr;
    for (const auto& run : formulation.runs) {
      const bool better = least == nullptr || rank_of(run) < rank_of(*least);
      if (seconds_of(run) <= best.seconds && better) least = &run;
    }
    if (least != nullptr) best.ranked.push_back({formulation.formulation, *least});
  }
  std::ranges::stable_sort(best.ranked, {}, [](const BestInTime& one) { return rank_of(one.run); });
  return best;
}

}  // namespace fde::bench
