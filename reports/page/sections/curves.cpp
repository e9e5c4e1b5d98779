// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fdebench/reports/analysis/parameter_curves.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "fdebench/reports/page/run_columns.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

json runs_of_curves(const PageInput& page, const ParameterCurves& curves) {
  std::vector<const Record*> runs;
  json values = json::array();
  for (const CurvePoint& point : curves.points) {
    runs.push_back(point.run);
    values.push_back(point.value);
  }
  json columns = run_columns(page, runs);
  columns["value"] = values;
  return columns;
}

// The common settings, without the defaults that parameter_curves() adds.
SceneSettings common_settings(const ParameterCurves& curves) {
  SceneSettings settings = curves.points.front().run->key.scene;
  settings.values.erase(curves.parameter);
  settings.until = curves.scene.until;
  return settings;
}

}  // namespace

json curve_sections(const PageInput& page) {
  json sections = json::array();
  for (const auto& curves : parameter_curves(page.runs)) {
    const auto scene = common_settings(curves);
    sections.push_back(
        {{"id", fmt::format("curve-{}{}-{}", label_of(scene), short_checksum(scene), curves.parameter)},
         {"scene", name_of_scene(page, scene).title},
         {"name", label_of(scene)},
         {"parameter", curves.parameter},
         {"steps", curves.steps},
         {"runs", runs_of_curves(page, curves)}});
  }
  return sections;
}

}  // namespace fde::bench
