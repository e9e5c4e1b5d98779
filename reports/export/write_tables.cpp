// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/results_scan.hpp"
#include "fdebench/reports/export/tables.hpp"

namespace fde::bench {
namespace {

Cell number(std::size_t index) { return static_cast<std::int64_t>(index); }
Cell flag(bool value) { return std::int64_t{value ? 1 : 0}; }
Cell or_null(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }
Cell or_null(std::string_view text) { return text.empty() ? Cell() : Cell(text); }

// An examination of a run, or the times of a run without one.
struct ExportedRun {
  const RunKey* key;
  std::size_t scene, session;
  int steps;
  double h;
  std::optional<RunOutcome> ending{};
  ProgramFacts program{};
  double ended_at = 0.0;
  bool latest = false;
};

// For each build that made a run its last examination, as an index; the build that measured last is last.
using LastOfBuilds = std::vector<std::pair<std::size_t, std::size_t>>;

// What the writer threw: scan_results would take another exception for a fault of the line that it reads.
struct WriterFailure {
  std::exception_ptr reason;
};

class TablesOfResults {
 public:
  explicit TablesOfResults(TableWriter& writer) : writer_(writer) {}

  void add(const Session& session) {
    const auto same =
        std::ranges::find_if(builds_, [&](const auto& of) { return same_build(of.first, session); });
    const std::size_t build = same == builds_.end() ? counts_.sessions : same->second;
    if (same == builds_.end()) builds_.emplace_back(session, build);
    build_ = build;
    put(TableId::sessions,
        std::vector<Cell>{number(counts_.sessions++), session.date, session.machine, number(session.cores),
                          session.system, session.compiler, session.flags, session.commit, session.version,
                          or_null(session.node), number(build)});
  }

  void add(const SceneDescription& scene) { descriptions_[scene_of(scene.scene)] = scene; }

  void add(const std::vector<Record>& rows) {
    const std::size_t run = run_of(rows);
    for (const Record& row : rows) {
      if (row.ending) {
        runs_[run].ending = row.ending;
        runs_[run].program = row.program;
        runs_[run].ended_at = row.value;
        continue;
      }
      put(TableId::results, std::vector<Cell>{number(counts_.results), number(run), number(row.session),
                                              row.quantity, row.value, row.unit, flag(row.wall_clock)});
      for (std::size_t i = 0; i < row.course.t.size(); ++i) {
        put(TableId::courses,
            std::vector<Cell>{number(counts_.results), row.course.t[i], row.course.value[i]});
      }
      ++counts_.results;
    }
  }

  ExportCounts finish() && {
    std::vector<const SceneSettings*> by_id(scenes_.size());
    for (const auto& [scene, id] : scenes_) by_id[id] = &scene;
    for (std::size_t id = 0; id < by_id.size(); ++id) write(*by_id[id], id);
    for (const auto& [key, made] : made_) {
      const auto latest = std::find_if(made.rbegin(), made.rend(),
                                       [&](const auto& of) { return runs_[of.second].ending.has_value(); });
      if (latest != made.rend()) runs_[latest->second].latest = true;
    }
    for (std::size_t id = 0; id < runs_.size(); ++id) write(runs_[id], id);
    writer_.finish();
    counts_.scenes = scenes_.size();
    counts_.runs = runs_.size();
    return counts_;
  }

 private:
  void put(TableId table, const std::vector<Cell>& row) {
    try {
      writer_.add(table, row);
    } catch (...) {
      throw WriterFailure{std::current_exception()};
    }
  }

  std::size_t scene_of(const SceneSettings& scene) {
    return scenes_.try_emplace(scene, scenes_.size()).first->second;
  }

  // The run that rows written together belong to: times to the last examination by the same build.
  std::size_t run_of(const std::vector<Record>& rows) {
    const Record& first = rows.front();
    const auto place = made_.try_emplace(first.key).first;
    LastOfBuilds& made = place->second;
    const auto found = std::ranges::find(made, build_, &LastOfBuilds::value_type::first);
    std::optional<std::size_t> run;
    if (found != made.end()) {
      run = found->second;
      made.erase(found);
    }
    if (!run || !std::ranges::all_of(rows, is_time)) {
      run = runs_.size();
      runs_.push_back({.key = &place->first,
                       .scene = scene_of(first.key.scene),
                       .session = first.session,
                       .steps = first.steps,
                       .h = first.h});
    }
    made.emplace_back(build_, *run);
    return *run;
  }

  void write(const SceneSettings& scene, std::size_t id) {
    const auto found = descriptions_.find(id);
    static const SceneDescription nothing;
    const auto& described = found == descriptions_.end() ? nothing : found->second;
    std::string line = found == descriptions_.end() ? "" : line_of(described);
    if (!line.empty()) line.pop_back();
    put(TableId::scenes,
        std::vector<Cell>{number(id), scene.id, or_null(scene.checksum), or_null(scene.until),
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
    put(TableId::parameters, std::vector<Cell>{number(scene), name, one == nullptr ? Cell() : Cell(*one),
                                               one == nullptr ? Cell(text) : Cell(), flag(given)});
  }

  void write(const ExportedRun& run, std::size_t id) {
    const auto& [resolution, grading, history, tolerance, budget] = run.key->setup;
    const auto* accuracy = std::get_if<Tolerance>(&resolution);
    const bool ours = !run.key->external;
    const std::string ending(run.ending ? name(run.ending->kind) : "");
    put(TableId::runs, std::vector<Cell>{number(id),
                                         number(run.session),
                                         number(run.scene),
                                         run.key->scheme,
                                         flag(!ours),
                                         or_null(run.program.code),
                                         or_null(run.program.version),
                                         or_null(run.program.language),
                                         std::int64_t{run.steps},
                                         run.h,
                                         accuracy == nullptr ? Cell() : Cell(accuracy->rtol),
                                         accuracy == nullptr ? Cell() : Cell(accuracy->atol),
                                         grading,
                                         ours ? Cell(name(history)) : Cell(),
                                         ours ? Cell(tolerance) : Cell(),
                                         ours && std::isfinite(budget) ? Cell(budget) : Cell(),
                                         or_null(ending),
                                         run.ending ? or_null(run.ending->detail) : Cell(),
                                         run.ending ? Cell(run.ended_at) : Cell(),
                                         flag(run.latest)});
  }

  TableWriter& writer_;
  ExportCounts counts_{};
  std::vector<std::pair<Session, std::size_t>> builds_{};  // with the number of the first session of each
  std::size_t build_ = 0;                                  // of the session that is read
  std::map<SceneSettings, std::size_t> scenes_{};
  std::map<std::size_t, SceneDescription> descriptions_{};
  std::map<RunKey, LastOfBuilds> made_{};
  std::vector<ExportedRun> runs_{};
};

}  // namespace

ExportCounts write_tables(const std::filesystem::path& file, TableWriter& writer) {
  try {
    TablesOfResults made(writer);
    const auto summary =
        scan_results(file, {.session = [&](const Session& session, auto) { made.add(session); },
                            .scene = [&](const SceneDescription& scene, auto) { made.add(scene); },
                            .rows = [&](const std::vector<Record>& rows, auto) { made.add(rows); }});
    auto counts = std::move(made).finish();
    counts.warning = summary.warning;
    return counts;
  } catch (const WriterFailure& failure) {
    std::rethrow_exception(failure.reason);
  }
}

}  // namespace fde::bench
