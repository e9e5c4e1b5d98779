// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "fdebench/benchmarks/records/results_file.hpp"
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
std::tuple<int, double, double> fineness(const RunSettings& settings) {
  if (const auto* steps = std::get_if<int>(&settings.resolution)) return {*steps, 0.0, 0.0};
  const auto& [relative, absolute] = std::get<Tolerance>(settings.resolution);
  return {0, -relative, -absolute};
}

// A record with the places of its scene and its scheme in the lists of this build.
struct Placed {
  std::ptrdiff_t scene = 0, scheme = 0;
  std::size_t index = 0;
};

// Sort key of runs. The runs of a line are contiguous.
auto order_of(const RunKey& key, const Placed& at) {
  RunSettings line = key.settings;
  line.resolution = std::holds_alternative<int>(line.resolution) ? StepsOrTolerance(0) : Tolerance{};
  return std::tuple<std::ptrdiff_t, const SceneSettings&, std::ptrdiff_t, const std::string&, RunSettings,
                    std::tuple<int, double, double>>(at.scene, key.scene, at.scheme, key.scheme, line,
                                                     fineness(key.settings));
}

// Of each run the last record, in the order of runs.
std::vector<Placed> latest_in_order(const std::vector<Record>& records) {
  std::vector<Placed> places;
  places.reserve(records.size());
  for (const Record& run : records) {
    places.push_back({position(scene_ids(), run.key.scene.id),
                      position(schemes(), run.key.scheme, &Scheme::id), places.size()});
  }
  const auto order = [&](const Placed& at) { return order_of(records[at.index].key, at); };
  std::ranges::sort(places, [&](const Placed& a, const Placed& b) {
    const auto of_a = order(a), of_b = order(b);
    return of_a < of_b || (of_a == of_b && a.index > b.index);
  });
  const auto same = [&](const Placed& a, const Placed& b) { return order(a) == order(b); };
  places.erase(std::unique(places.begin(), places.end(), same), places.end());
  return places;
}

// Leaves these records, in this order. They are many: there is no copy.
void rearrange(std::vector<Record>& records, const std::vector<Placed>& order) {
  std::vector<std::size_t> place(records.size()), held(records.size());  // of a record; the record at a place
  std::iota(place.begin(), place.end(), std::size_t{0});
  std::iota(held.begin(), held.end(), std::size_t{0});
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto from = place[order[i].index];
    std::swap(records[i], records[from]);
    held[from] = std::exchange(held[i], order[i].index);
    place[held[from]] = from;
  }
  records.erase(records.begin() + std::ssize(order), records.end());
}

template <typename Same>
std::vector<RunSpan> chunks(RunSpan runs, Same same) {
  std::vector<RunSpan> found;
  for (auto first = runs.begin(); first != runs.end();) {
    const auto last =
        std::find_if_not(first, runs.end(), [&](const Record& run) { return same(*first, run); });
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

const SceneSettings& scene_of_run(const Record& run) { return run.key.scene; }

bool same_scene(const Record& a, const Record& b) { return a.key.scene == b.key.scene; }

}  // namespace

std::optional<MedianInterval> time_of(const Record& run) {
  const auto least = run["time_minimum"];
  if (!least) return std::nullopt;
  const double median = run["time_median"].value_or(*least);
  return MedianInterval{median, run["time_low"].value_or(*least), run["time_high"].value_or(median)};
}

const SceneDescription* Runs::describe(const SceneSettings& scene) const {
  const auto found = scenes.find(scene);
  return found == scenes.end() ? nullptr : &found->second;
}

Runs runs_of(Results results) {
  auto order = latest_in_order(results.records);
  const auto is_finished = [&](const Placed& at) {
    return results.records[at.index].ending.kind == SolveStatus::finished;
  };
  const auto first_failed = std::stable_partition(order.begin(), order.end(), is_finished) - order.begin();
  rearrange(results.records, order);
  Runs runs;
  runs.failed.assign(std::make_move_iterator(results.records.begin() + first_failed),
                     std::make_move_iterator(results.records.end()));
  results.records.erase(results.records.begin() + first_failed, results.records.end());
  runs.finished = std::move(results.records);
  for (SceneDescription& scene : results.scenes) {
    auto& described = runs.scenes[scene.scene];
    described = std::move(scene);
  }
  compare_over_common_columns(runs);
  return runs;
}

void count_first_runs(Runs& runs) {
  for (Record& run : runs.finished) {
    const double setup = run["time_setup"].value_or(0.0);
    run.timing.first_run = true;
    for (const auto* time : {"time_minimum", "time_median", "time_low", "time_high"}) {
      if (const auto later = run[time]) run.timing.values.set(time, *later + setup);
    }
  }
}

ReadRuns read_runs(Results results) {
  ReadRuns read{.sessions = results.sessions, .warning = results.warning};
  read.runs = runs_of(std::move(results));
  return read;
}

ReadRuns read_runs(const std::filesystem::path& file) {
  Results results = read_results(file, Examinations::latest);
  if (results.records.empty()) {
    throw std::invalid_argument(results.warning.empty() ? fmt::format("{}: holds no run", file.string())
                                                        : fmt::format("{}: no run is left", results.warning));
  }
  return read_runs(std::move(results));
}

std::vector<RunSpan> by_scene(RunSpan runs) { return chunks(runs, same_scene); }

std::vector<RunSpan> by_line(RunSpan runs) {
  return chunks(runs, [](const Record& a, const Record& b) {
    return same_scene(a, b) && a.key.scheme == b.key.scheme && same_series(a.key.settings, b.key.settings);
  });
}

RunSpan of_scene(RunSpan runs, const SceneSettings& scene) {
  return {std::ranges::lower_bound(runs, scene, precedes, scene_of_run),
          std::ranges::upper_bound(runs, scene, precedes, scene_of_run)};
}

}  // namespace fde::bench
