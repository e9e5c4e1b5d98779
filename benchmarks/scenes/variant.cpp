#include "scenes/variant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "scenes/number_text.hpp"
#include "scenes/registry.hpp"

namespace fde {
namespace {

// "b=1,2,c=3" into "b=1,2" and "c=3": what has no '=' belongs to the list before it.
std::vector<std::string> split_settings(std::string_view text) {
  std::vector<std::string> settings;
  for (const auto& part : split_list(text)) {
    if (settings.empty() || part.find('=') != std::string::npos) {
      settings.push_back(part);
    } else {
      settings.back() += "," + part;
    }
  }
  return settings;
}

}  // namespace

SceneSettings SceneVariant::key() const { return {.id = maker->id, .values = values, .until = until}; }

Scene make_known_scene(const SceneMaker& maker, const ParameterValues& values) {
  const Parameters parameters(maker.id, maker.parameters, values);
  Scene scene = maker.make(parameters);
  scene.name = fmt::format("{} {}", maker.id, parameters.text());
  return scene;
}

Scene make_scene(const SceneMaker& maker, const ParameterValues& values) {
  Scene scene = make_known_scene(maker, values);
  if (!scene.refusal.empty()) throw std::invalid_argument(scene.refusal);
  return scene;
}

Scene make_scene(const SceneVariant& variant) {
  Scene scene = make_scene(*variant.maker, variant.values);
  if (!variant.until) return scene;
  const double end = scene.problem.end;
  if (two_sided(scene.problem) && *variant.until != end) {
    reject("until", *variant.until,
           fmt::format("{}: scene {} is posed at both ends", end, variant.maker->id));
  }
  scene.problem.end = *variant.until;
  return scene;
}

ParameterValues parse_settings(const SceneMaker& maker, const std::vector<std::string>& settings) {
  ParameterValues values;
  for (const auto& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) reject_text("--set", setting, "NAME=VALUE");
    const auto name = setting.substr(0, equals);
    const auto& parameter = parameter_named(name, maker.id, maker.parameters);
    auto value = parameter.read(std::string_view(setting).substr(equals + 1));
    if (!values.emplace(name, std::move(value)).second)
      reject_text("--set", setting, "one value for each name");
  }
  return values;
}

SceneVariant parse_variant(const std::string& text, const Scenes& among) {
  constexpr std::string_view until = "until=";
  const auto colon = text.find(':');
  SceneVariant variant{.maker = &scene_named(text.substr(0, colon), among)};
  if (colon == std::string::npos) return variant;
  auto settings = split_settings(std::string_view(text).substr(colon + 1));
  const auto end =
      std::ranges::find_if(settings, [&](const auto& setting) { return setting.starts_with(until); });
  if (end != settings.end()) {
    variant.until = parse_number("until", end->substr(until.size()), any_end);
    settings.erase(end);
  }
  variant.values = parse_settings(*variant.maker, settings);
  [[maybe_unused]] const Scene checked = make_scene(variant);
  return variant;
}

}  // namespace fde
