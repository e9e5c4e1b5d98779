// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "fdebench/reports/page/run_columns.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// A logarithmic axis shows positive values only.
std::optional<double> above_zero(const MeasuredRun& run, std::string_view quantity) {
  const auto value = run[quantity];
  return value && *value > 0.0 ? value : std::nullopt;
}

json runs_of_scene(const PageInput& page, RunSpan scene) {
  std::vector<const MeasuredRun*> runs;
  for (const MeasuredRun& run : scene) runs.push_back(&run);
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

// A note that names the runs with error 0, which a logarithmic chart cannot show.
std::string not_drawn(const PageInput& page, RunSpan scene) {
  std::vector<std::string> names;
  for (const MeasuredRun& run : scene) {
    if (run["error_end"] && !above_zero(run, "error_end")) {
      names.push_back(fmt::format("{} at N = {}", page.label(run.key), count_text(run.steps)));
    }
  }
  if (names.empty()) return {};
  return fmt::format("Not in the charts, because the error at the end is exactly 0: {}.",
                     fmt::join(names, ", "));
}

// A note that names the lines whose times are of whole processes.
std::string on_wall_clock(const PageInput& page, RunSpan scene) {
  std::set<std::string> names;
  for (const MeasuredRun& run : scene) {
    if (run.wall_clock) names.insert(page.label(run.key));
  }
  if (names.empty()) return {};
  return fmt::format("Times of whole processes, by the wall clock and with their start: {}.",
                     fmt::join(names, ", "));
}

// The parameters in which the solution is not continuous at their present values, as sentences.
std::string not_continuous(const SceneSettings& settings) {
  const auto scene = known_scene(settings);
  if (!scene) return {};
  std::vector<std::string> sentences;
  for (const auto& [parameter, limit] : scene->discontinuities) {
    sentences.push_back(fmt::format(
        "The solution is not continuous in {0} here: as {0} tends to its value, {1}.", parameter, limit));
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

// Adds the equations and parameters of the scene to its section.
void add_scene(json& section, const SceneSettings& scene) {
  if (auto equations = equations_of(scene); !equations.empty()) section["equations"] = std::move(equations);
  if (const auto parameters = parameters_table(scene); !parameters.empty())
    section["parameters"] = to_json(parameters);
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
    const auto label = label_of(solved);
    const auto [title, source] = name_of_scene(solved);
    std::vector<std::string> paragraphs;
    for (const auto& text :
         {source, not_continuous(solved), not_drawn(page, scene), on_wall_clock(page, scene)}) {
      if (!text.empty()) paragraphs.push_back(text);
    }
    const SceneLines lines(page.runs, solved);
    json answers = json::object(), conclusions = json::object();
    for (const ErrorKind& kind : error_kinds) {
      answers[error_measure(kind)] = to_json(scene_answers(page, solved, lines, kind));
      conclusions[error_measure(kind)] = conclusion(page, lines, scene, kind);
    }
    json section{{"id", section_of(solved)},
                 {"title", title},
                 {"tables", answers},
                 {"name", label},
                 {"paragraphs", paragraphs},
                 {"conclusions", conclusions},
                 {"runs", runs_of_scene(page, scene)},
                 {"rates", rates_of_scene(page, scene)}};
    add_scene(section, solved);
    if (auto solution = solution_of(solved); !solution.empty()) section["solution"] = std::move(solution);
    sections.push_back(std::move(section));
  }
  share_solutions(sections);
  return sections;
}

}  // namespace fde::bench
