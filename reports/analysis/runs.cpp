// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "fdebench/benchmarks/records/results_scan.hpp"
#include "fdebench/benchmarks/scenes/scene_ids.hpp"
#include "fdebench/reports/analysis/compared_columns.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

// Index of an id in a list; its length for an unknown id, which is sorted last.
template <class List, class Id = std::identity>
std::ptrdiff_t position(const List& list, const std::string& of, Id id = {}) {
  return std::ranges::find(list, of, id) - list.begin();
}

// Increases with resolution: more steps, or a smaller tolerance.
std::tuple<int, double, double> fineness(const RunSettings& setup) {
  if (const auto* steps = std::get_if<int>(&setup.resolution)) return {*steps, 0.0, 0.0};
  const auto& [relative, absolute] = std::get<Tolerance>(setup.resolution);
  return {0, -relative, -absolute};
}

// Sort key of runs. The runs of a line are contiguous.
auto order_of(const RunKey& key) {
  RunSettings line = key.setup;
  line.resolution = std::holds_alternative<int>(line.resolution) ? StepsOrTolerance(0) : Tolerance{};
  return std::tuple(position(scene_ids(), key.scene.id), key.scene,
                    position(schemes(), key.scheme, &Scheme::id), key.scheme, line, fineness(key.setup));
}
using Order = decltype(order_of({}));

// A run made by one build, and the session of its examination.
struct BuildRun {
  MeasuredRun run{};
  std::size_t examined = 0;
  bool begun = false, ended = false;
};

// Adds a row to a run. Times may be from a later session than the examination, on another machine; any other
// row of a later session restarts the run.
void add(BuildRun& made, const Record& row) {
  auto& run = made.run;
  if (!made.begun || (row.session != made.examined && !is_time(row))) {
    made = {.run = {.key = row.key, .steps = row.steps, .h = row.h}, .examined = row.session, .begun = true};
  }
  run.session = row.session;
  if (row.ending) {
    run.ending = *row.ending;
    run.program = row.program;
    run.columns = row.columns;
    made.ended = true;
  } else {
    run.values.set(row.quantity, row.value);
    if (!row.course.empty()) run.courses[row.quantity] = row.course;
    if (is_time(row)) run.wall_clock = row.wall_clock;
  }
}

// The run as made by each build, the latest last.
using RunsByBuild = std::vector<std::pair<std::size_t, BuildRun>>;

BuildRun& run_of(RunsByBuild& made, std::size_t build) {
  const auto found = std::ranges::find(made, build, &RunsByBuild::value_type::first);
  std::pair<std::size_t, BuildRun> one{build, {}};
  if (found != made.end()) {
    one = std::move(*found);
    made.erase(found);
  }
  return made.emplace_back(std::move(one)).second;
}

// Collects runs from a sequence of rows.
class Collector {
 public:
  void begin(const Session& session) {
    const auto first =
        std::ranges::find_if(sessions_, [&](const auto& one) { return same_build(one, session); });
    builds_.push_back(static_cast<std::size_t>(first - sessions_.begin()));
    sessions_.push_back(session);
  }

  // Rows of one run and session.
  void take(std::span<const Record> rows) {
    BuildRun& made = run_of(all_[order_of(rows.front().key)], builds_[rows.front().session]);
    for (const Record& row : rows) add(made, row);
  }

  void take(const SceneDescription& scene) { scenes_.insert_or_assign(scene.scene, scene); }

  [[nodiscard]] const std::vector<Session>& sessions() const { return sessions_; }

  Runs runs() && {
    Runs runs{.finished = {}, .failed = {}, .scenes = std::move(scenes_)};
    for (auto& [order, made] : all_) {
      std::erase_if(made, [](const auto& one) { return !one.second.ended; });  // without an examination
      if (made.empty()) continue;
      auto& run = made.back().second.run;
      (run.ending.kind == SolveStatus::finished ? runs.finished : runs.failed).push_back(std::move(run));
    }
    compare_over_common_columns(runs);
    return runs;
  }

 private:
  std::vector<Session> sessions_{};
  std::vector<std::size_t> builds_{};  // for each session the first session of the same build
  std::map<Order, RunsByBuild> all_{};
  std::map<SceneSettings, SceneDescription> scenes_{};
};

template <typename Same>
std::vector<RunSpan> chunks(RunSpan runs, Same same) {
  std::vector<RunSpan> found;
  for (auto first = runs.begin(); first != runs.end();) {
    const auto last =
        std::find_if_not(first, runs.end(), [&](const MeasuredRun& run) { return same(*first, run); });
    found.emplace_back(first, last);
    first = last;
  }
  return found;
}

// Whether the runs of a scene come before those of the other.
bool precedes(const SceneSettings& a, const SceneSettings& b) {
  const auto place_of_a = position(scene_ids(), a.id), place_of_b = position(scene_ids(), b.id);
  return std::tie(place_of_a, a) < std::tie(place_of_b, b);
}

const SceneSettings& scene_of_run(const MeasuredRun& run) { return run.key.scene; }

bool same_scene(const MeasuredRun& a, const MeasuredRun& b) { return a.key.scene == b.key.scene; }

}  // namespace

std::optional<double> MeasuredRun::operator[](std::string_view quantity) const { return values[quantity]; }

std::optional<MedianInterval> time_of(const MeasuredRun& run) {
  const auto least = run["time_minimum"];
  if (!least) return std::nullopt;
  const double median = run["time_median"].value_or(*least);
  return MedianInterval{median, run["time_low"].value_or(*least), run["time_high"].value_or(median)};
}

const SceneDescription* Runs::describe(const SceneSettings& scene) const {
  const auto found = scenes.find(scene);
  return found == scenes.end() ? nullptr : &found->second;
}

ReadRuns read_runs(const Results& results) { return {results.sessions, runs_of(results), results.warning}; }

Runs runs_of(const Results& results) {
  Collector collector;
  for (const Session& session : results.sessions) collector.begin(session);
  for (const SceneDescription& scene : results.scenes) collector.take(scene);
  for (const Record& row : results.records) collector.take(std::span(&row, 1));
  return std::move(collector).runs();
}

void count_first_runs(Runs& runs) {
  for (MeasuredRun& run : runs.finished) {
    const double setup = run["time_setup"].value_or(0.0);
    run.first_run = true;
    for (const auto* time : {"time_minimum", "time_median", "time_low", "time_high"}) {
      if (const auto later = run[time]) run.values.set(time, *later + setup);
    }
  }
}

ReadRuns read_runs(const std::filesystem::path& file) {
  Collector collector;
  const auto summary =
      scan_results(file, {.session = [&](const Session& session, auto) { collector.begin(session); },
                          .scene = [&](const SceneDescription& scene, auto) { collector.take(scene); },
                          .rows = [&](const std::vector<Record>& rows, auto) { collector.take(rows); }});
  ReadRuns read{.sessions = collector.sessions(), .warning = summary.warning};
  read.runs = std::move(collector).runs();
  if (read.runs.finished.empty() && read.runs.failed.empty()) {
    throw std::invalid_argument(read.warning.empty() ? fmt::format("{}: holds no run", file.string())
                                                     : fmt::format("{}: no run is left", read.warning));
  }
  return read;
}

std::vector<RunSpan> by_scene(RunSpan runs) { return chunks(runs, same_scene); }

std::vector<RunSpan> by_line(RunSpan runs) {
  return chunks(runs, [](const MeasuredRun& a, const MeasuredRun& b) {
    return same_scene(a, b) && a.key.scheme == b.key.scheme && same_series(a.key.setup, b.key.setup);
  });
}

RunSpan of_scene(RunSpan runs, const SceneSettings& scene) {
  return {std::ranges::lower_bound(runs, scene, precedes, scene_of_run),
          std::ranges::upper_bound(runs, scene, precedes, scene_of_run)};
}

}  // namespace fde::bench
