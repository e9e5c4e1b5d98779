// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/plot_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "fdebench/benchmarks/records/description_text.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/sweep/sampled_solution.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "fdebench/reports/regions/stability_curves.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

constexpr std::size_t most_members = 24;  // of a family in one chart
constexpr std::ptrdiff_t most_drawn_times = 8000;
constexpr int points = 48;  // of a stability curve

json page_of(json section) {
  return {{"lines", json::array()}, {"kinds", json::array()}, {"sections", {std::move(section)}}};
}

json solution(const SceneVariant& of, bool with_all_columns) {
  SampleLimits limits{.times = most_drawn_times};
  if (with_all_columns) limits.columns = std::numeric_limits<Eigen::Index>::max();
  const Scene scene = make_scene_unchecked(of);
  require_start_at_zero(scene, "plot");
  try {
    return json_of(sample_solution(scene, reference_of(scene), limits));
  } catch (const std::runtime_error& none) {
    throw std::invalid_argument(fmt::format("{}: has no reference to draw: {}", of.label(), none.what()));
  }
}

// The parameter in which the scenes differ. Throws std::invalid_argument unless it is exactly one.
std::string parameter_of(const std::vector<SceneVariant>& scenes) {
  std::set<std::string> differing;
  for (const SceneVariant& scene : scenes) {
    for (const auto& [name, value] : scene.values)
      if (scenes.front().values.at(name) != value) differing.insert(name);
  }
  if (differing.size() != 1) {
    throw std::invalid_argument(
        fmt::format("--set: a figure is over one parameter, not {}",
                    differing.empty() ? "the end" : fmt::format("{}", fmt::join(differing, ", "))));
  }
  return *differing.begin();
}

// Of a family over the parameter.
json member(const SceneVariant& of, const std::string& parameter, bool with_all_columns) {
  json made{{"value", to_text(of.values.at(parameter))}, {"solution", solution(of, with_all_columns)}};
  for (const auto& [name, limit] : make_scene_unchecked(of).discontinuities)
    if (name == parameter) made["limits"].push_back(limit);
  return made;
}

}  // namespace

json data_of_runs(ReadRuns read, const SceneSettings& scene) {
  for (auto* some : {&read.runs.finished, &read.runs.failed})
    std::erase_if(*some, [&](const Record& run) { return run.key.scene != scene; });
  if (read.runs.finished.empty())
    throw std::invalid_argument(fmt::format("--results: has no run of {} that finished", label_of(scene)));
  json data = page_data(std::move(read));
  std::erase_if(data["sections"].get_ref<json::array_t&>(), [](const json& section) {
    return !section.contains("runs") || section.contains("parameter");
  });
  return data;
}

json data_of_drifts(ReadRuns read, const SceneSettings& scene) {
  PageInput page{.sessions = std::move(read.sessions), .names = LineNames::of_several_scenes(read.runs)};
  page.runs = std::move(read.runs);
  for (const auto& constrained : constrained_scenes(page.runs)) {
    if (constrained.scene != scene) continue;
    const json drifts = drift_charts(page, constrained);
    json data = page_of({{"id", section_of(scene)}, {"drifts", {drifts}}});
    data["lines"] = drifts["points"]["lines"];
    return data;
  }
  throw std::invalid_argument(
      fmt::format("--results: has no run of {} with a drift from constraints", label_of(scene)));
}

json data_of_solutions(const std::vector<SceneVariant>& scenes, bool with_all_columns) {
  const auto& first = scenes.front();
  json section{{"id", section_of(first.key())}, {"title", with_settings(first.factory->title, first.key())}};
  if (scenes.size() == 1) {
    section["solution"] = solution(first, with_all_columns);
    return page_of(std::move(section));
  }
  if (scenes.size() > most_members) {
    throw std::invalid_argument(
        fmt::format("--set: {} values, a figure can show {}", scenes.size(), most_members));
  }
  const auto parameter = parameter_of(scenes);
  json members = json::array();
  for (const auto& scene : scenes) members.push_back(member(scene, parameter, with_all_columns));
  section["family"] = {{"parameter", parameter}, {"members", std::move(members)}};
  return page_of(std::move(section));
}

json data_of_measurements(SceneVariant scene, const ExternalTrajectory& measured) {
  if (!is_two_sided(make_scene_unchecked(scene).problem)) scene.until = measured.times.back();
  const Scene posed = make_scene_unchecked(scene);
  json section{{"id", section_of(scene.key())},
               {"title", scene.factory->title},
               {"solution", solution(scene, true)},
               {"measured", json::array()}};
  MemoizedReference reference(posed, measured.columns);
  const Rows model = reference.at(measured.times);
  for (Eigen::Index i = 0; i < measured.values.cols(); ++i) {
    for (Eigen::Index c = 0; c < measured.values.rows(); ++c) {
      if (std::isnan(measured.values(c, i))) continue;
      const auto column = static_cast<std::size_t>(measured.columns[static_cast<std::size_t>(c)]);
      json& point = section["measured"].emplace_back();
      point = {{"t", measured.times[static_cast<std::size_t>(i)]},
               {"column", posed.outputs.names[column]},
               {"value", measured.values(c, i)},
               {"residual", measured.values(c, i) - model(c, i)}};
      if (measured.deviations.size() > 0) point["deviation"] = measured.deviations(c, i);
    }
  }
  return page_of(std::move(section));
}

json data_of_regions(const SceneVariant& of) {
  const Scene scene = make_scene(of);
  std::set<double> orders;
  for (const auto& component : scene.problem.components) orders.insert(component.order);
  if (orders.size() != 1 || !scene.problem.equations.empty()) {
    throw std::invalid_argument(fmt::format(
        "{}: has several orders; regions of stability are of one, as of relaxation:gamma=0.5", of.label()));
  }
  return page_of(
      {{"id", "regions"}, {"regions", stability_curves(all_schemes(), {*orders.begin()}, points)}});
}

}  // namespace fde::bench
