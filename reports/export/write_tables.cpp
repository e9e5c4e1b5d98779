// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/record_validation.hpp"
#include "fdebench/benchmarks/records/results_index.hpp"
#include "fdebench/reports/export/tables.hpp"

namespace fde::bench {
namespace {

Cell number(std::size_t index) { return static_cast<std::int64_t>(index); }
Cell flag(bool value) { return std::int64_t{value ? 1 : 0}; }
Cell or_null(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }
Cell or_null(std::string_view text) { return text.empty() ? Cell() : Cell(text); }

// The contents of a results file as rows of the tables. Descriptions and runs are read when they are written.
class TablesOfResults {
 public:
  TablesOfResults(const std::filesystem::path& file, TableWriter& writer)
      : index_(index_results(file)), lines_(file), writer_(writer) {
    for (const auto& [scene, descriptions] : index_.scenes) scenes_.emplace(scene, scenes_.size());
  }

  ExportCounts write() && {
    for (std::size_t id = 0; id < index_.sessions.size(); ++id) write(index_.sessions[id], id);
    for (const auto& [scene, id] : scenes_) write(scene, id);
    for (std::size_t id = 0; id < index_.runs.size(); ++id) write(read_record(lines_, index_.runs[id]), id);
    writer_.finish();
    return {index_.sessions.size(), scenes_.size(), index_.runs.size(), written_, index_.warning};
  }

 private:
  void put(TableId table, std::initializer_list<Cell> row) { writer_.add(table, row); }

  void write(const Session& session, std::size_t id) {
    const auto first = std::ranges::find_if(index_.sessions,
                                            [&](const Session& other) { return same_build(other, session); });
    put(TableId::sessions,
        {number(id), session.date, session.machine, number(session.cores), session.system, session.compiler,
         session.flags, session.commit, session.version, or_null(session.node),
         number(static_cast<std::size_t>(first - index_.sessions.begin()))});
  }

  void write(const SceneSettings& scene, std::size_t id) {
    const auto& descriptions = index_.scenes.at(scene);
    SceneDescription described;
    std::string line;
    if (!descriptions.empty()) {
      described = read_scene(lines_, descriptions.back());
      line = line_of(described);
      line.pop_back();
    }
    put(TableId::scenes, {number(id), scene.id, or_null(scene.checksum), or_null(scene.until),
                          or_null(described.title), or_null(described.source), or_null(described.evidence),
                          or_null(described.reference_seconds), or_null(line)});
    ParameterValues defaults;
    for (const auto& parameter : described.parameters) {
      if (!scene.values.contains(parameter.name))
        defaults.emplace(parameter.name, parse_value(parameter.value));
    }
    for (const auto& [name, value] : scene.values) write(id, name, value, true);
    for (const auto& [name, value] : defaults) write(id, name, value, false);
  }

  void write(std::size_t scene, const std::string& name, const ParameterValue& value, bool given) {
    const auto* one = std::get_if<double>(&value);
    const auto* word = std::get_if<std::string>(&value);
    const auto* list = std::get_if<std::vector<double>>(&value);
    const std::string text = word != nullptr   ? *word
                             : list != nullptr ? nlohmann::json(*list).dump()
                                               : std::string();
    put(TableId::parameters, {number(scene), name, one == nullptr ? Cell() : Cell(*one),
                              one == nullptr ? Cell(text) : Cell(), flag(given)});
  }

  void write(const Record& run, std::size_t id) {
    const auto& [resolution, grading, history, newton_tolerance, budget] = run.key.settings;
    const auto* accuracy = std::get_if<Tolerance>(&resolution);
    const bool ours = !run.key.external;
    put(TableId::runs, {number(id),
                        number(run.session),
                        number(scenes_.at(run.key.scene)),
                        run.key.scheme,
                        flag(!ours),
                        or_null(run.program.code),
                        or_null(run.program.version),
                        or_null(run.program.language),
                        std::int64_t{run.steps},
                        run.h(),
                        accuracy == nullptr ? Cell() : Cell(accuracy->rtol),
                        accuracy == nullptr ? Cell() : Cell(accuracy->atol),
                        grading,
                        ours ? Cell(name(history)) : Cell(),
                        ours ? Cell(newton_tolerance) : Cell(),
                        ours && std::isfinite(budget) ? Cell(budget) : Cell(),
                        name(run.ending.kind),
                        or_null(run.ending.detail),
                        run.ended_at,
                        flag(index_.runs[id].is_latest)});
    write(run, id, run.values, run.session);
    write(run, id, run.timing.values, run.timing.session);
  }

  void write(const Record& run, std::size_t id, const QuantityValues& values, std::size_t session) {
    for (const auto& [quantity, value] : values) {
      const bool wall_clock = run.timing.wall_clock && &values == &run.timing.values;
      put(TableId::results, {number(written_), number(id), number(session), quantity, value,
                             unit_of(quantity), flag(wall_clock)});
      const auto course = run.courses.find(quantity);
      for (std::size_t i = 0; course != run.courses.end() && i < course->second.t.size(); ++i)
        put(TableId::courses, {number(written_), course->second.t[i], course->second.value[i]});
      ++written_;
    }
  }

  ResultsIndex index_;
  LinesByOffset lines_;
  TableWriter& writer_;
  std::map<SceneSettings, std::size_t> scenes_{};
  std::size_t written_ = 0;  // rows of the table of results
};

}  // namespace

ExportCounts write_tables(const std::filesystem::path& file, TableWriter& writer) {
  return TablesOfResults(file, writer).write();
}

}  // namespace fde::bench
