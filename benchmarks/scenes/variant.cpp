#include "scenes/variant.hpp"

#include <fmt/format.h>

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

// NAME=VALUE, of a parameter or of the end.
void add_setting(const std::string& setting, SceneVariant& variant) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos || equals == 0) reject_text("--set", setting, "NAME=VALUE");
  const auto name = setting.substr(0, equals);
  const auto value = std::string_view(setting).substr(equals + 1);
  bool first = !variant.until;
  if (name == "until") {
    variant.until = parse_number(name, value, any_end);
  } else {
    const auto& parameter = parameter_named(name, variant.maker->id, variant.maker->parameters);
    first = variant.values.emplace(name, parameter.read(value)).second;
  }
  if (!first) reject_text("--set", setting, "one value for each name");
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

SceneVariant read_variant(const std::string& text, const std::vector<std::string>& settings,
                          const Scenes& among) {
  const auto colon = text.find(':');
  SceneVariant variant{.maker = &scene_named(text.substr(0, colon), among)};
  auto all = colon == std::string::npos ? std::vector<std::string>{}
                                        : split_settings(std::string_view(text).substr(colon + 1));
  all.insert(all.end(), settings.begin(), settings.end());
  for (const auto& setting : all) add_setting(setting, variant);
  return variant;
}

SceneVariant parse_variant(const std::string& text, const Scenes& among) {
  return parse_variant(text, {}, among);
}

SceneVariant parse_variant(const std::string& text, const std::vector<std::string>& settings,
                           const Scenes& among) {
  SceneVariant variant = read_variant(text, settings, among);
  [[maybe_unused]] const Scene checked = make_scene(variant);
  return variant;
}

}  // namespace fde
