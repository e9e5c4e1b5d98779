// SPDX-License-Identifier: MIT
#include "fdebench/reports/page/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "fdebench/reports/analysis/families.hpp"
#include "fdebench/reports/page/assets.hpp"
#include "fdebench/reports/page/facts.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// The kinds of error that the page's controls offer.
json kinds() {
  json all = json::array();
  for (const ErrorKind& kind : error_kinds) {
    all.push_back({{"id", error_measure(kind)}, {"norm", name(kind.norm)}, {"scale", name(kind.scale)}});
  }
  return all;
}

// The labels of all lines: sorted by the cells of the map that they win, then in the order of the list of
// schemes. The order determines the colours: only the first few lines have a unique one.
std::vector<std::string> line_labels(const PageInput& page) {
  std::vector<std::string> labels = page.labels({page.runs.finished});
  for (auto& label : page.labels({page.families.finished}))
    if (std::ranges::find(labels, label) == labels.end()) labels.push_back(std::move(label));
  auto won = cells_won(page, {});
  std::ranges::stable_sort(labels, std::greater{}, [&](const std::string& label) { return won[label]; });
  return labels;
}

bool is_trial(const Runs& runs, const RunKey& run) {
  const auto* described = runs.describe(run.scene);
  if (described == nullptr || !described->trial) return false;
  const auto& [number, kind, steps, accuracy] = *described->trial;
  return run.settings.resolution == StepsOrTolerance(steps) ||
         run.settings.resolution == StepsOrTolerance(accuracy);
}

// Returns the runs of trials, and removes those of scenes without other runs from `runs`.
std::vector<Record> take_trials(Runs& runs) {
  std::vector<Record> taken;
  std::set<SceneSettings> swept;
  for (auto* some : {&runs.finished, &runs.failed}) {
    for (const auto& run : *some)
      is_trial(runs, run.key) ? taken.push_back(run) : void(swept.insert(run.key.scene));
  }
  for (auto* some : {&runs.finished, &runs.failed}) {
    std::erase_if(
        *some, [&](const Record& run) { return is_trial(runs, run.key) && !swept.contains(run.key.scene); });
  }
  return taken;
}

// Whether every run keeps the constraint to rounding.
bool at_rounding(const ConstrainedScene& scene) {
  return std::ranges::all_of(scene.formulations, [](const FormulationRuns& of) {
    return std::ranges::all_of(of.runs,
                               [](const Record& run) { return effective_drift(run) <= rounding_drift; });
  });
}

// Distinguishes equation files of the same name.
std::string file_text(const SceneSettings& scene) {
  return scene.checksum.empty() ? "" : fmt::format(", file {}", short_checksum(scene));
}

// The stability regions, which depend on no results and are computed in advance.
json regions_section() { return {{"id", "regions"}, {"regions", json::parse(assets::regions())}}; }

}  // namespace

std::vector<std::string> PageInput::labels(std::initializer_list<RunSpan> of) const {
  std::vector<std::string> found;
  const auto add = [&](const auto& is_next) {
    for (const RunSpan some : of) {
      for (const Record& run : some) {
        if (!is_next(run)) continue;
        auto name = label(run.key);
        if (std::ranges::find(found, name) == found.end()) found.push_back(std::move(name));
      }
    }
  };
  for (const Scheme& scheme : schemes()) add([&](const Record& run) { return run.key.scheme == scheme.id; });
  add([](const Record&) { return true; });
  return found;
}

// Settings change neither title nor source.
SceneName name_of_scene(const PageInput& page, const SceneSettings& scene) {
  const auto& scenes = page.runs.scenes;
  const auto of_id = scenes.lower_bound(SceneSettings{.id = scene.id});
  const auto found = std::find_if(of_id, scenes.end(), [&](const auto& described) {
    return described.first.id != scene.id || described.first.checksum == scene.checksum;
  });
  if (found == scenes.end() || found->first.id != scene.id)
    return {.title = fmt::format("{}{}", label_of(scene), file_text(scene))};
  return {.title = with_settings(found->second.title, scene), .source = found->second.source};
}

std::string with_settings(const std::string& title, const SceneSettings& scene) {
  const auto settings = settings_text(scene);
  return fmt::format("{}{}{}", title, settings.empty() ? "" : fmt::format(" ({})", settings),
                     file_text(scene));
}

std::string section_of(const SceneSettings& scene) {
  return fmt::format("scene-{}{}", label_of(scene), short_checksum(scene));
}

json page_data(ReadRuns read, const std::optional<ReadRuns>& before) {
  PageInput page{.sessions = std::move(read.sessions), .names = LineNames::of_several_scenes(read.runs)};
  page.runs = std::move(read.runs);
  json compared = before ? compared_section(page, before->runs) : json();
  page.trials = take_trials(page.runs);
  page.families = take_families(page.runs);
  page.rates = rates(page.runs);
  json sections = json::array();
  const auto add = [&](json section) {
    section = compact(std::move(section));
    if (section.contains("groups") && section["groups"].front().contains("rows"))
      sections.push_back(std::move(section));
  };
  if (json answers = answers_section(page); !answers.empty()) sections.push_back(std::move(answers));
  if (json codes = codes_section(page); !codes.is_null()) sections.push_back(compact(std::move(codes)));
  if (before) sections.push_back(compact(std::move(compared)));
  for (auto& family : family_sections(page)) sections.push_back(std::move(family));
  add(stability_section(page));
  sections.push_back(regions_section());
  for (auto& scene : scene_sections(page)) sections.push_back(std::move(scene));
  for (auto& curves : curve_sections(page)) sections.push_back(std::move(curves));
  add(rates_section(page));
  add(drift_section(page));
  if (sections.back()["id"] == "drift") {
    for (const auto& scene : constrained_scenes(page.runs)) {
      if (!at_rounding(scene)) sections.back()["drifts"].push_back(drift_charts(page, scene));
    }
  }
  for (auto* const section_of_page :
       {cost_section, expansion_section, reference_section, failures_section, schemes_section})
    add(section_of_page(page));
  return {{"lines", line_labels(page)},
          {"kinds", kinds()},
          {"sessions", session_facts(page)},
          {"sections", sections}};
}

}  // namespace fde::bench
