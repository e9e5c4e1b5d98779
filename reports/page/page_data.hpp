#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/formulations.hpp"
#include "analysis/line_names.hpp"
#include "analysis/line_rates.hpp"
#include "analysis/option.hpp"
#include "page/table.hpp"
#include "scenes/scene.hpp"

namespace fde {

// All that the page shows, as its script takes it: lines, sessions, sections. Numbers in tables are text
// already. before: results that these are set against, a section of their own.
nlohmann::json page_data(ReadRuns read, const std::optional<ReadRuns>& before = {});

// What the sections are made from.
struct PageInput {
  std::vector<Session> sessions{};
  Runs runs{};                        // but for those that only a trial asked for
  std::vector<MeasuredRun> trials{};  // the runs of trials, finished or not
  std::vector<RateRow> rates{};
  LineNames names;

  // What the run's line is called on the page.
  [[nodiscard]] std::string label(const RunKey& run) const { return names.name(run.scheme, run.setup); }
  [[nodiscard]] std::string label(const Option& of) const { return names.name(of.schemes.front(), of.setup); }
  [[nodiscard]] std::string label(const RateRow& of) const { return names.name(of.scheme, of.setup); }
  // The line's grid where its name does not tell it; otherwise nothing.
  [[nodiscard]] std::string grid(const Setup& setup) const { return names.grid(setup); }
};

// A titled part of the page; what is empty is left out.
struct Section {
  std::string id, title;
  std::vector<std::string> paragraphs{};
  Table table{};
  std::vector<Table> tables{};  // in its place one for each of error_kinds()
  bool folded = false;          // shown when asked for
};

Table sessions_table(const PageInput& page);
// The cheapest run of each scene and accuracy, as a map.
Section answers_section(const PageInput& page);
// How many cells of the map each line wins.
std::map<std::string, int> cells_won(const PageInput& page, const ErrorKind& kind);
// Of each scheme a row, the one that wins most cells first: where it is cheapest, and where it fails, is
// inaccurate or refuses.
Table scheme_verdicts(const PageInput& page, const ErrorKind& kind);
// The cheapest run of each accuracy of one scene, with all that is known of the run.
Table scene_answers(const PageInput& page, const SceneSettings& scene, const SceneLines& lines,
                    const ErrorKind& kind);
// Why the first of two lines of a scene is quicker than the second, as the records show it: fewer steps, by
// its rate, or cheaper ones.
std::string reason_it_leads(const PageInput& page, const SceneSettings& scene, const Option& first,
                            const Option& second, Norm norm);
// What changed since other results, as `compare` has it.
Section compared_section(const PageInput& page, const Runs& before);
Section rates_section(const PageInput& page);
Section drift_section(const PageInput& page);
Section stability_section(const PageInput& page);
Section cost_section(const PageInput& page);
Section expansion_section(const PageInput& page);
Section reference_section(const PageInput& page);
Section failures_section(const PageInput& page);
Section schemes_section(const PageInput& page);

// In words which line of a scene is cheapest to which accuracy and why, what no run reaches, who does not
// solve it.
std::string conclusion(const PageInput& page, const SceneLines& lines, RunSpan runs, const ErrorKind& kind);
// What a scene says of itself: its equations as formulas, values and meanings of its parameters; and its
// solution for drawing: times, columns, values, the largest bound. Each empty where there is none.
nlohmann::json equations_of(const SceneSettings& scene);
Table parameters_table(const SceneSettings& scene);
nlohmann::json solution_of(const SceneSettings& settings);
// The scene itself; nullopt where this build does not know it, as that of a file, or cannot make it.
std::optional<Scene> known_scene(const SceneSettings& settings);
// The same of a scene that is at hand: t, columns, values, bound; energy, reactions and motion as columns and
// values too. Throws where there is no reference.
nlohmann::json solution_of(const Scene& scene);
// The drifts of a constrained scene by formulation: those of all runs, and in the course of time of the run
// that keeps the constraint best within a time that all were given, solved anew.
nlohmann::json drift_charts(const PageInput& page, const ConstrainedScene& scene);

// A section for each scene with its runs and the rates of its lines.
nlohmann::json scene_sections(const PageInput& page);

// A section for each parameter in which alone at least three scenes differ: errors and times over it.
nlohmann::json curve_sections(const PageInput& page);

// Title and source of a scene; the id alone for one that this build does not know.
struct SceneName {
  std::string title, source{};
};
SceneName name_of_scene(const SceneSettings& scene);
// The id of its section.
std::string section_of(const SceneSettings& scene);

}  // namespace fde
