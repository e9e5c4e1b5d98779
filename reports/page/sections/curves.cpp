#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/parameter_curves.hpp"
#include "analysis/text.hpp"
#include "page/page_data.hpp"
#include "scenes/registry.hpp"
#include "scenes/scene.hpp"

namespace fde {
namespace {

using nlohmann::json;

json point(const PageInput& page, const CurvePoint& of, const std::string& parameter) {
  const MeasuredRun& run = *of.run;
  json shown{
      {"line", page.label(run.key)}, {"value", of.value}, {"steps", run.steps}, {"errors", errors_of(run)}};
  json words = json::array({{"title", page.label(run.key)}, {parameter, fmt::format("{}", of.value)}});
  words.push_back({"N", count_text(run.steps)});
  for (const ErrorKind& kind : error_kinds()) {
    if (const auto error = run[error_measure(kind)]) words.push_back({error_title(kind), error_text(*error)});
  }
  if (const auto seconds = run["time_minimum"]) {
    words.push_back({"time", fmt::format("{}{}", time_text(*seconds), clock_note(run.wall_clock))});
    if (*seconds > 0.0) shown["seconds"] = *seconds;  // the axis is logarithmic
  }
  shown["words"] = words;
  return shown;
}

// What of the scene is not its default, but for the parameter.
SceneSettings told(const ParameterCurves& curves) {
  SceneSettings told = curves.scene;
  if (const auto* maker = find_scene(told.id)) {
    for (const auto& parameter : maker->parameters) {
      const auto value = told.values.find(parameter.name);
      if (value != told.values.end() && value->second == parameter.value) told.values.erase(value);
    }
  }
  return told;
}

}  // namespace

json curve_sections(const PageInput& page) {
  json sections = json::array();
  for (const auto& curves : parameter_curves(page.runs)) {
    const auto scene = told(curves);
    json points = json::array();
    for (const auto& of : curves.points) points.push_back(point(page, of, curves.parameter));
    sections.push_back(
        {{"id", fmt::format("curve-{}{}-{}", label_of(scene), short_checksum(scene), curves.parameter)},
         {"title", fmt::format("{} over {}", name_of_scene(scene).title, curves.parameter)},
         {"name", label_of(scene)},
         {"paragraphs",
          json::array({fmt::format("Every run has N = {}, the most steps that all lines have in common.",
                                   count_text(curves.steps))})},
         {"parameter", curves.parameter},
         {"points", points}});
  }
  return sections;
}

}  // namespace fde
