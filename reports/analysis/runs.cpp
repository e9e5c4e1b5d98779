#include "analysis/runs.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "scenes/registry.hpp"
#include "scenes/scene.hpp"
#include "stepping/scheme.hpp"
#include "sweep/ending.hpp"

namespace fde {
namespace {

// Where a scheme stands in the list; ids that this build does not know come last, as do scenes.
std::ptrdiff_t position_of_scheme(std::string_view id) {
  const Scheme* scheme = find_scheme(id);
  return scheme == nullptr ? std::ssize(schemes()) : scheme - schemes().data();
}

std::ptrdiff_t position_of_scene(std::string_view label) {
  const auto& known = scenes();
  const auto found = std::ranges::find_if(
      known, [scene = scene_of_label(label)](const auto& maker) { return &maker == scene; });
  return found - known.begin();
}

using Key = std::tuple<std::ptrdiff_t, std::string, std::ptrdiff_t, std::string, std::string, int>;

Key key_of(const Record& row) {
  return {position_of_scene(row.scene),
          row.scene,
          position_of_scheme(row.scheme),
          row.scheme,
          row.history,
          row.steps};
}

// For each session the first one of the same build on the same machine.
std::vector<std::size_t> builds_of(const std::vector<Session>& sessions) {
  std::vector<std::size_t> builds;
  for (const Session& session : sessions) {
    const auto first =
        std::ranges::find_if(sessions, [&](const auto& one) { return same_build(one, session); });
    builds.push_back(static_cast<std::size_t>(first - sessions.begin()));
  }
  return builds;
}

// The times of a run may be of a later session than its examination. Any other row of a later session begins
// the run again.
void add(MeasuredRun& run, const Record& row) {
  if (run.scene.empty() || (row.session != run.session && !is_time(row))) {
    run = {.scene = row.scene,
           .scheme = row.scheme,
           .history = row.history,
           .steps = row.steps,
           .h = row.h,
           .tolerance = row.tolerance,
           .session = row.session};
  }
  if (row.quantity == "outcome") {
    run.status = row.status;
  } else {
    run.values[row.quantity] = row.value;
  }
}

// One run as each build made it, the latest last.
using Made = std::vector<std::pair<std::size_t, MeasuredRun>>;

MeasuredRun& run_of(Made& made, std::size_t build) {
  const auto found = std::ranges::find(made, build, &Made::value_type::first);
  std::pair<std::size_t, MeasuredRun> one{build, {}};
  if (found != made.end()) {
    one = std::move(*found);
    made.erase(found);
  }
  return made.emplace_back(std::move(one)).second;
}

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

bool same_scene(const MeasuredRun& a, const MeasuredRun& b) { return a.scene == b.scene; }

}  // namespace

std::optional<double> MeasuredRun::operator[](std::string_view quantity) const {
  const auto found = values.find(quantity);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

Runs runs_of(const Results& results) {
  const auto builds = builds_of(results.sessions);
  std::map<Key, Made> all;
  for (const Record& row : results.records) add(run_of(all[key_of(row)], builds[row.session]), row);
  Runs runs;
  for (auto& [key, made] : all) {
    std::erase_if(made, [](const auto& one) { return one.second.status.empty(); });  // times of no run
    if (made.empty()) continue;
    auto& run = made.back().second;
    (ending_of(run.status) == Ending::finished ? runs.finished : runs.failed).push_back(std::move(run));
  }
  return runs;
}

std::vector<RunSpan> by_scene(RunSpan runs) { return chunks(runs, same_scene); }

std::vector<RunSpan> by_line(RunSpan runs) {
  return chunks(runs, [](const MeasuredRun& a, const MeasuredRun& b) {
    return same_scene(a, b) && a.scheme == b.scheme && a.history == b.history;
  });
}

RunSpan of_scene(RunSpan runs, std::string_view scene) {
  for (const RunSpan found : by_scene(runs)) {
    if (found.front().scene == scene) return found;
  }
  return {};
}

}  // namespace fde
