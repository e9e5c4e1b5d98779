// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/recorded_recommendation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fdebench/reports/analysis/line_names.hpp"
#include "fdebench/reports/analysis/scene_lines.hpp"

namespace fde::bench {
namespace {

// From the solution that the results file has of the scene.
std::vector<SmallColumn> small_columns(const Runs& runs, const Recommendation& made) {
  const auto* scene = runs.describe(made.scene);
  if (scene == nullptr || !scene->solution) return {};
  std::vector<std::string> names;
  std::vector<double> largest;
  const auto& columns = scene->solution->columns;
  for (std::size_t i = 0; i < columns.names.size(); ++i) {
    const auto& name = columns.names[i];
    if (!made.columns.empty() && std::ranges::find(made.columns, name) == made.columns.end()) continue;
    names.push_back(name);
    largest.push_back(0.0);
    for (const auto& value : columns.values[i])
      largest.back() = std::max(largest.back(), std::abs(value.value_or(0.0)));
  }
  return small_columns(made.kind, made.accuracy, names, largest);
}

}  // namespace

Recommendation recommend(const Runs& runs, const SceneSettings& scene, const ErrorKind& kind,
                         double accuracy) {
  const LineNames names(runs);
  const SceneLines lines(runs, scene);
  Recommendation made{
      .scene = scene, .kind = kind, .accuracy = accuracy, .options = lines.within(kind, accuracy)};
  if (const auto compared = runs.compared.find(scene); compared != runs.compared.end())
    made.columns = compared->second;
  made.small = small_columns(runs, made);
  for (RecommendedRun& option : made.options) option = with_prediction(std::move(option), runs, scene, kind);
  if (!made.options.empty()) return made;
  const auto missed = lines.shortfall(kind, accuracy, lines.forecasts(kind));
  if (!missed) {
    made.missing.push_back(fmt::format("no finished run has {}", error_measure(kind)));
    return made;
  }
  const auto name = [&](const RecommendedRun& of) { return names.name(of.schemes.front(), of.settings); };
  made.missing.push_back(fmt::format("best: {}: {}", name(missed->best), run_text(missed->best)));
  if (missed->known_up_to) {
    made.missing.push_back(
        fmt::format("the reference is known up to {} only", error_text(*missed->known_up_to)));
  }
  if (missed->untimed > 0) {
    made.missing.push_back(
        fmt::format("{} runs within it are not timed yet: continue the sweep", missed->untimed));
  }
  if (missed->steps_needed) made.missing.push_back(needed_text(name(missed->line), *missed->steps_needed));
  return made;
}

}  // namespace fde::bench
