// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reports/analysis/parameter_curves.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "fdebench/reports/page/run_columns.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

json runs_of_curves(const PageInput& page, const ParameterCurves& curves) {
  std::vector<const MeasuredRun*> runs;
  json values = json::array();
  for (const CurvePoint& point : curves.points) {
    runs.push_back(point.run);
    values.push_back(point.value);
  }
  json columns = run_columns(page, runs);
  columns["value"] = values;
  return columns;
}

// The common settings without those that equal their defaults.
SceneSettings without_defaults(const ParameterCurves& curves) {
  SceneSettings settings = curves.scene;
  if (const auto* maker = find_scene(settings.id)) {
    for (const auto& parameter : maker->parameters) {
      const auto value = settings.values.find(parameter.name);
      if (value != settings.values.end() && value->second == parameter.value) settings.values.erase(value);
    }
  }
  return settings;
}

}  // namespace

json curve_sections(const PageInput& page) {
  json sections = json::array();
  for (const auto& curves : parameter_curves(page.runs)) {
    const auto scene = without_defaults(curves);
    sections.push_back(
        {{"id", fmt::format("curve-{}{}-{}", label_of(scene), short_checksum(scene), curves.parameter)},
         {"scene", name_of_scene(scene).title},
         {"name", label_of(scene)},
         {"parameter", curves.parameter},
         {"steps", curves.steps},
         {"runs", runs_of_curves(page, curves)}});
  }
  return sections;
}

}  // namespace fde::bench
