// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/reports/analysis/formulations.hpp"
#include "fdebench/reports/analysis/line_names.hpp"
#include "fdebench/reports/analysis/line_rates.hpp"
#include "fdebench/reports/analysis/scene_lines.hpp"

namespace fde::bench {

// The data of the page as JSON for its script: lines, sessions, sections. They are facts without words, which
// the templates of the page (section_texts.js, statements.js) make sentences and tables of;
// docs/page.schema.json has the fields. A function of the results alone: nothing is solved or measured for
// it, and scenes need not exist. `before`: earlier results, compared with these in a separate section.
nlohmann::json page_data(ReadRuns read, const std::optional<ReadRuns>& before = {});

// The input of the sections.
struct PageInput {
  std::vector<Session> sessions{};
  Runs runs{};                   // without runs that belong to trials only, or to families
  Runs families{};               // the runs of families
  std::vector<Record> trials{};  // the runs of trials, finished or not
  std::vector<RateRow> rates{};
  LineNames names;

  // The name of the run's line on the page.
  [[nodiscard]] std::string label(const RunKey& run) const { return names.name(run.scheme, run.settings); }
  [[nodiscard]] std::string label(const RecommendedRun& of) const {
    return names.name(of.schemes.front(), of.settings);
  }
  [[nodiscard]] std::string label(const RateRow& of) const { return names.name(of.scheme, of.settings); }
  // The labels of the lines of these runs, without repetitions, in the order of the list of schemes; those of
  // schemes that this build does not have last.
  [[nodiscard]] std::vector<std::string> labels(std::initializer_list<RunSpan> of) const;
  // The line's grid if its name omits it; otherwise empty.
  [[nodiscard]] std::string grid(const RunSettings& settings) const { return names.grid(settings); }
};

// Date, machine, compiler and flags of each session.
nlohmann::json session_facts(const PageInput& page);
// The accuracies and the verdicts on the schemes; the answers themselves are in the sections of the scenes.
// null without finished runs.
nlohmann::json answers_section(const PageInput& page);
// The number of cells of the map in which each line is the cheapest.
std::map<std::string, int> cells_won(const PageInput& page, const ErrorKind& kind);
// For each line in the order of the list of schemes: where it is nearest to the cheapest, by the ids of kinds
// of error, and where it fails, is inaccurate or refuses.
nlohmann::json scheme_verdicts(const PageInput& page);
// The cheapest run of one scene for each accuracy, with the data of the run and its distance from the others;
// otherwise the best run.
nlohmann::json scene_answers(const PageInput& page, const SceneSettings& scene, const SceneLines& lines,
                             const ErrorKind& kind);
// Why the first of two lines of a scene is quicker than the second by the records: fewer steps (because of
// its rate) or cheaper steps.
nlohmann::json reason_for_speed(const PageInput& page, const SceneSettings& scene,
                                const RecommendedRun& first, const RecommendedRun& second, Norm norm);
// Beside other codes: for each scene that other programs were run on, each code's quickest run within each
// accuracy, by kinds of error. null without such runs.
nlohmann::json codes_section(const PageInput& page);
// The changes since earlier results, by compare().
nlohmann::json compared_section(const PageInput& page, const Runs& before);
// Observed and theoretical rates; drift from constraints; trials; cost at the finest step; decoupled chain
// against commensurate expansion; bounds of the references; refused and failed runs; the list of schemes. A
// section whose `groups` are empty is not shown.
nlohmann::json rates_section(const PageInput& page);
nlohmann::json drift_section(const PageInput& page);
nlohmann::json stability_section(const PageInput& page);
nlohmann::json cost_section(const PageInput& page);
nlohmann::json expansion_section(const PageInput& page);
nlohmann::json reference_section(const PageInput& page);
nlohmann::json failures_section(const PageInput& page);
nlohmann::json schemes_section(const PageInput& page);

// The conclusion on one scene: which line is cheapest for which accuracy and why, the accuracies that no run
// reaches, and the schemes that do not solve it.
nlohmann::json conclusion(const PageInput& page, const SceneLines& lines, RunSpan runs,
                          const ErrorKind& kind);
// The drifts of a constrained scene by formulation: of all runs, and as a function of t for the run of
// best_in_time().
nlohmann::json drift_charts(const PageInput& page, const ConstrainedScene& scene);

// One section per scene, with its runs and the rates of its lines.
nlohmann::json scene_sections(const PageInput& page);

// One section per parameter with at least three scenes that differ in it alone: errors and times over its
// values.
nlohmann::json curve_sections(const PageInput& page);

// One section per family: over the plane of two of its parameters the cheapest run of each scene for each
// accuracy, and how robust that is.
nlohmann::json family_sections(const PageInput& page);

// Title and source of a scene; the label alone for a scene that the results do not describe.
struct SceneName {
  std::string title, source{};
};
SceneName name_of_scene(const PageInput& page, const SceneSettings& scene);
// "Fractional pendulum (alpha=1.9)" from the title alone; for an equation file "Decay (k=2), file 0a1b2c3d".
std::string with_settings(const std::string& title, const SceneSettings& scene);
// The id of the scene's section.
std::string section_of(const SceneSettings& scene);

}  // namespace fde::bench
