// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "fdebench/reports/analysis/trial_result.hpp"
#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// The scenes of the trials, in their order.
std::vector<const SceneDescription*> scenes_of(const PageInput& page) {
  std::vector<const SceneDescription*> scenes;
  for (const auto& entry : page.runs.scenes) {
    const auto of_this = [&](const Record& run) { return run.key.scene == entry.first; };
    if (std::ranges::any_of(page.trials, of_this)) scenes.push_back(&entry.second);
  }
  std::ranges::stable_sort(scenes, {}, [](const auto* scene) { return scene->trial->number; });
  return scenes;
}

// The verdict on a trial with its reason, and how `fdebench solve` repeats it; null if it was not run.
json cell(const PageInput& page, const SceneSettings& scene, int steps, const std::string& line) {
  const auto found = std::ranges::find_if(
      page.trials, [&](const Record& run) { return run.key.scene == scene && page.label(run.key) == line; });
  if (found == page.trials.end()) return {};
  json facts{{"verdict", trial_result(*found).word},
             {"error", fact((*found)["error_relative"])},
             {"rounding_from", fact((*found)["rounding_from"])},
             {"seconds", fact((*found)["time_minimum"])},
             {"wall_clock", found->timing.wall_clock}};
  if (!found->key.external) {
    facts["scheme"] = found->key.scheme;
    facts["options"] = options_of(found->key.settings, steps);
  }
  if (found->ending.kind != SolveStatus::finished) facts.update(ending_facts(found->ending));
  return facts;
}

// The number of a line's trials, and how many of them survive, stop rightly or are refused.
json counts(const PageInput& page, const std::string& line) {
  std::map<TrialResult, int> of_result;
  int total = 0;
  for (const auto& run : page.trials) {
    if (page.label(run.key) != line) continue;
    ++of_result[trial_result(run)];
    ++total;
  }
  const auto some = [&](const TrialResult& of) { return of_result[of] > 0 ? json(of_result[of]) : json(); };
  return {
      {"survive", of_result[survives]}, {"trials", total}, {"stop", some(stops)}, {"refused", some(refuses)}};
}

json row(const PageInput& page, const SceneDescription& of, const std::vector<std::string>& lines) {
  json cells = json::array();
  for (const auto& line : lines) cells.push_back(cell(page, of.scene, of.trial->steps, line));
  return {{"scene", label_of(of.scene)}, {"steps", of.trial->steps}, {"cells", cells}};
}

}  // namespace

json stability_section(const PageInput& page) {
  const auto lines = page.labels({page.trials});
  if (lines.empty()) return {};
  json totals = json::array();
  for (const auto& line : lines) totals.push_back(counts(page, line));
  json groups = json::array({{{"rows", json::array({{{"cells", totals}}})}}});
  for (const SceneDescription* of : scenes_of(page)) {
    if (groups.back().value("title", "") != of->trial->kind) groups.push_back({{"title", of->trial->kind}});
    groups.back()["rows"].push_back(row(page, *of, lines));
  }
  return {{"id", "stability"}, {"lines", lines}, {"groups", groups}};
}

}  // namespace fde::bench
