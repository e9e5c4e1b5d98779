// SPDX-License-Identifier: MIT
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "fdebench/benchmarks/records/description_text.hpp"
#include "fdebench/reports/analysis/compared_columns.hpp"
#include "fdebench/reports/page/facts.hpp"
#include "fdebench/reports/page/run_columns.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

json runs_of_scene(const PageInput& page, RunSpan scene) {
  std::vector<const Record*> runs;
  for (const Record& run : scene) runs.push_back(&run);
  return run_columns(page, runs);
}

// The theoretical rates of the lines with at least two runs.
json rates_of_scene(const PageInput& page, RunSpan scene) {
  json shown = json::array();
  for (const RunSpan line : by_line(scene)) {
    const RateRow rate = rate_of(line);
    if (line.size() < 2 || (!rate.end.expected && !rate.maximum.expected)) continue;
    json one{{"line", page.label(line.front().key)}};
    if (rate.end.expected) one["end"] = *rate.end.expected;
    if (rate.maximum.expected) one["maximum"] = *rate.maximum.expected;
    shown.push_back(one);
  }
  return shown;
}

// The runs with error 0, which a logarithmic chart cannot show.
json not_drawn(const PageInput& page, RunSpan scene) {
  json runs = json::array();
  for (const Record& run : scene) {
    if (run["error_end"] == 0.0) runs.push_back({{"line", page.label(run.key)}, {"steps", run.steps}});
  }
  return runs;
}

// The lines whose times are of whole processes.
std::set<std::string> on_wall_clock(const PageInput& page, RunSpan scene) {
  std::set<std::string> names;
  for (const Record& run : scene) {
    if (run.timing.wall_clock) names.insert(page.label(run.key));
  }
  return names;
}

// What the results say of the scene: the parameters in which the solution is not continuous at their present
// values, with its limit there, the equations as text that the page typesets, the parameters, the solution.
json description_facts(const SceneDescription& scene) {
  json facts = json::object();
  for (const auto& [parameter, limit] : scene.discontinuities)
    facts["discontinuities"].push_back({{"parameter", parameter}, {"limit", limit}});
  for (const auto& [left, right] : scene.equations)
    facts["equations"].push_back({{"left", left}, {"right", right}});
  for (const auto& [name, value, meaning, given] : scene.parameters) {
    facts["parameters"].push_back(
        compact({{"name", name}, {"value", value}, {"meaning", meaning}, {"given", given}}));
  }
  if (scene.solution) facts["solution"] = json_of(*scene.solution);
  return facts;
}

// Formulations of one scene have the same solution: it is stored in the first of their sections only.
void share_solutions(json& sections) {
  std::map<std::string, std::string> seen;
  for (auto& section : sections) {
    if (!section.contains("solution")) continue;
    const auto [first, is_new] = seen.try_emplace(section["solution"].dump(), section["id"]);
    if (!is_new) section["solution"] = {{"of", first->second}};
  }
}

}  // namespace

json scene_sections(const PageInput& page) {
  json sections = json::array();
  for (const RunSpan scene : by_scene(page.runs.finished)) {
    const SceneSettings& solved = scene.front().key.scene;
    const auto [title, source] = name_of_scene(page, solved);
    const SceneLines lines(page.runs, solved);
    json answers = json::object(), conclusions = json::object();
    for (const ErrorKind& kind : error_kinds) {
      answers[error_measure(kind)] = scene_answers(page, solved, lines, kind);
      conclusions[error_measure(kind)] = conclusion(page, lines, scene, kind);
    }
    json section = compact({{"id", section_of(solved)},
                            {"title", title},
                            {"name", label_of(solved)},
                            {"source", source},
                            {"compared_columns", compared_text(page.runs, solved)},
                            {"not_drawn", not_drawn(page, scene)},
                            {"on_wall_clock", on_wall_clock(page, scene)},
                            {"answers", answers},
                            {"conclusions", conclusions}});
    section["runs"] = runs_of_scene(page, scene);
    section["rates"] = rates_of_scene(page, scene);
    if (const auto* described = page.runs.describe(solved)) section.update(description_facts(*described));
    sections.push_back(std::move(section));
  }
  share_solutions(sections);
  return sections;
}

}  // namespace fde::bench
