// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/parameter_curves.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "fdebench/reports/analysis/scene_numbers.hpp"

namespace fde::bench {
namespace {

// Runs of scenes that differ in one parameter, by its value.
using ScenesByValue = std::map<double, RunSpan>;

// A scheme with its settings except the resolution.
using Line = std::pair<std::string, RunSettings>;

Line line_of(const RunKey& run) {
  Line line{run.scheme, run.settings};
  line.second.resolution = 1;
  return line;
}

// The numbers of steps that each line has at all its values. Lines with too few values and lines with
// adaptive step size are left out.
std::map<Line, std::set<int>> common_steps(const ScenesByValue& family) {
  std::map<Line, std::set<int>> steps;
  std::map<Line, std::size_t> values;
  for (const auto& [value, scene] : family) {
    for (const RunSpan runs : by_line(scene)) {
      if (!std::holds_alternative<int>(runs.front().key.settings.resolution)) continue;
      const Line line = line_of(runs.front().key);
      std::set<int> here, both;
      for (const Record& run : runs) here.insert(run.steps);
      if (values[line]++ == 0) steps[line] = here;
      std::ranges::set_intersection(steps[line], here, std::inserter(both, both.end()));
      steps[line] = both;
    }
  }
  std::erase_if(steps, [&](const auto& line) { return values[line.first] < fewest_values; });
  return steps;
}

// The largest number common to all sets.
std::optional<int> largest_common(const std::map<Line, std::set<int>>& steps) {
  if (steps.empty()) return std::nullopt;
  const auto& first = steps.begin()->second;
  const auto found = std::find_if(first.rbegin(), first.rend(), [&](int count) {
    return std::ranges::all_of(steps, [&](const auto& line) { return line.second.contains(count); });
  });
  return found == first.rend() ? std::nullopt : std::optional(*found);
}

std::vector<CurvePoint> points_of(const ScenesByValue& family, const std::map<Line, std::set<int>>& lines,
                                  int steps) {
  std::vector<CurvePoint> points;
  for (const auto& [value, scene] : family) {
    for (const Record& run : scene) {
      if (run.steps == steps && lines.contains(line_of(run.key))) points.push_back({value, &run});
    }
  }
  return points;
}

}  // namespace

std::vector<ParameterCurves> parameter_curves(const Runs& runs) {
  std::map<std::pair<SceneSettings, std::string>, ScenesByValue> families;
  for (const RunSpan scene : by_scene(runs.finished)) {
    const auto whole = with_defaults(runs, scene.front().key.scene);
    for (const auto& [name, value] : numbers_of(whole))
      families[{without(whole, name), name}].emplace(value, scene);
  }
  std::vector<ParameterCurves> curves;
  for (const auto& [of, family] : families) {
    if (family.size() < fewest_values) continue;
    const auto lines = common_steps(family);
    const auto steps = largest_common(lines);
    if (!steps) continue;
    curves.push_back({of.first, of.second, *steps, points_of(family, lines, *steps)});
  }
  return curves;
}

}  // namespace fde::bench
