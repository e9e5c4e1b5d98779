// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/compared_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

namespace fde::bench {
namespace {

constexpr std::string_view other_columns = "judged_over_other_columns";

// The run with the errors over these columns; false if they are not recorded. A number of significant digits
// is of all columns.
bool set_errors(Record& run, const std::vector<std::string>& columns) {
  const auto measures = measures_of_columns(run.columns, columns);
  for (const auto& [id, value] : measures) value ? run.values.set(id, *value) : run.values.erase(id);
  run.values.erase("mescd");
  return !measures.empty();
}

// Moves the finished runs of the scene for which `leave` is true to `failed`.
template <class Condition>
void move_to_failed(Runs& runs, const SceneSettings& scene, const Condition& leave) {
  std::vector<Record> left;
  std::erase_if(runs.finished, [&](Record& run) {
    if (run.key.scene != scene || !leave(run)) return false;
    const auto& names = run.columns.names;
    run.ending = {outcome_named(other_columns), fmt::format("{}", fmt::join(names, ", "))};
    left.push_back(std::move(run));
    return true;
  });
  const auto end = of_scene(runs.failed, scene).end() - RunSpan(runs.failed).begin();
  runs.failed.insert(runs.failed.begin() + end, std::make_move_iterator(left.begin()),
                     std::make_move_iterator(left.end()));
}

// The columns of which every run has errors, in the order of the first run.
std::vector<std::string> common_columns(RunSpan runs) {
  std::vector<std::string> common = runs.front().columns.names;
  for (const Record& run : runs) {
    std::erase_if(common, [&](const auto& name) {
      return run.columns.values.empty() ||
             std::ranges::find(run.columns.names, name) == run.columns.names.end();
    });
  }
  return common;
}

}  // namespace

void compare_over(Runs& runs, const SceneSettings& scene, const std::vector<std::string>& columns) {
  move_to_failed(runs, scene, [&](Record& run) { return !set_errors(run, columns); });
  runs.compared[scene] = columns;
}

void compare_over_common_columns(Runs& runs) {
  const auto is_part = [](const Record& run) { return run.columns.is_part; };
  std::set<SceneSettings> scenes;
  for (const Record& run : runs.finished)
    if (is_part(run)) scenes.insert(run.key.scene);
  for (const SceneSettings& scene : scenes) {
    const auto columns = common_columns(of_scene(runs.finished, scene));
    columns.empty() ? move_to_failed(runs, scene, is_part) : compare_over(runs, scene, columns);
  }
}

std::string not_compared_text(const Runs& runs, const SceneSettings& scene) {
  std::set<std::string> programs;
  for (const Record& run : of_scene(runs.failed, scene)) {
    if (name(run.ending.kind) == other_columns)
      programs.insert(fmt::format("{}, judged over {}", run.key.scheme, run.ending.detail));
  }
  return programs.empty() ? "" : fmt::format("not compared: {}", fmt::join(programs, "; "));
}

std::string compared_text(const Runs& runs, const SceneSettings& scene) {
  const auto found = runs.compared.find(scene);
  return found == runs.compared.end() ? "" : fmt::format("{}", fmt::join(found->second, ", "));
}

}  // namespace fde::bench
