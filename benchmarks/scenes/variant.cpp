// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/variant.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {
namespace {

// "b=1,2,c=3" into "b=1,2" and "c=3": a part without '=' continues the preceding list.
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

// "pendulum" from "pendulum:alpha=1.9", and all settings.
struct SplitLabel {
  std::string id;
  std::vector<std::string> settings;
};

// Position of the ':' before the settings: the first colon, for a file the first one after its name.
std::size_t colon_of(const std::string& text) {
  const auto file = equation_file_of_label(text);
  return text.find(':', file ? file->size() : 0);
}

SplitLabel split_label(const std::string& text, const std::vector<std::string>& settings) {
  const auto colon = colon_of(text);
  SplitLabel named{.id = text.substr(0, colon), .settings = {}};
  if (colon != std::string::npos) named.settings = split_settings(std::string_view(text).substr(colon + 1));
  named.settings.insert(named.settings.end(), settings.begin(), settings.end());
  return named;
}

// "gamma=0.1:0.9:0.1" into "gamma=0.1", ..., "gamma=0.9"; a setting without a range is returned unchanged.
std::vector<std::string> values_of(const std::string& setting) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos || setting.find(':', equals) == std::string::npos) return {setting};
  const std::string name = setting.substr(0, equals);
  std::vector<std::string> all;
  for (const auto& value :
       expand_decimal_range(name, std::string_view(setting).substr(equals + 1), max_variants))
    all.push_back(fmt::format("{}={}", name, value));
  return all;
}

// NAME=VALUE: the end, or a parameter whose value `read` parses. Scene: SceneVariant or SceneSettings.
template <class Scene, class Reader>
void add_setting(const std::string& setting, Scene& scene, const Reader& read) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos || equals == 0) reject_text("setting", setting, "NAME=VALUE");
  const auto name = setting.substr(0, equals);
  const auto value = std::string_view(setting).substr(equals + 1);
  bool first = !scene.until;
  if (name == "until") {
    scene.until = parse_number(name, value, valid_end_times);
  } else {
    first = scene.values.emplace(name, read(name, value)).second;
  }
  if (!first) reject_text("setting", setting, "one value for each name");
}

void add_setting(const std::string& setting, SceneVariant& variant) {
  add_setting(setting, variant, [&](const std::string& name, std::string_view value) {
    return parameter_named(name, variant.factory->id, variant.factory->parameters).read(value);
  });
}

}  // namespace

SceneSettings SceneVariant::key() const {
  return {.id = factory->id, .values = values, .until = until, .checksum = factory->checksum};
}

SceneSettings SceneVariant::key_of_solution() const {
  SceneSettings of_solution = key();
  for (const Parameter& parameter : factory->parameters)
    if (parameter.keeps_solution) of_solution.values.erase(parameter.name);
  return of_solution;
}

Scene make_scene_unchecked(const SceneFactory& factory, const ParameterValues& values) {
  const Parameters parameters(factory.id, factory.parameters, values);
  Scene scene = factory.make(parameters);
  const auto rows = scene.smoothness.powers.size(), components = scene.problem.components.size();
  if (rows != 0 && rows != components && scene.ill_posed_reason.empty()) {
    throw std::invalid_argument(
        fmt::format("scene {}: its smoothness has {} rows for {} components", factory.id, rows, components));
  }
  scene.name =
      fmt::format("{} {}", factory.checksum.empty() ? factory.id : factory.checksum, parameters.text());
  return scene;
}

Scene make_scene(const SceneFactory& factory, const ParameterValues& values) {
  Scene scene = make_scene_unchecked(factory, values);
  if (!scene.ill_posed_reason.empty()) throw std::invalid_argument(scene.ill_posed_reason);
  return scene;
}

namespace {

Scene with_end(Scene scene, const SceneVariant& variant) {
  if (!variant.until) return scene;
  const double until = *variant.until;
  if (has_right_rows(scene.problem) && until != end_time(scene)) {
    reject("until", until,
           fmt::format("{}: scene {} is posed at both ends", end_time(scene), variant.factory->id));
  }
  if (!(until > scene.start)) reject("until", until, fmt::format("above {}, the start", scene.start));
  set_end(scene, from_start(scene, until));
  return scene;
}

}  // namespace

Scene make_scene(const SceneVariant& variant) {
  return with_end(make_scene(*variant.factory, variant.values), variant);
}

Scene make_scene_unchecked(const SceneVariant& variant) {
  return with_end(make_scene_unchecked(*variant.factory, variant.values), variant);
}

SceneVariant read_variant(const std::string& text, const std::vector<std::string>& settings,
                          const SceneRegistry& among) {
  const auto named = split_label(text, settings);
  SceneVariant variant{.factory = &among.named(named.id)};
  for (const auto& setting : named.settings) add_setting(setting, variant);
  return variant;
}

SceneSettings read_settings(const std::string& text, const std::vector<std::string>& settings) {
  const auto named = split_label(text, settings);
  SceneSettings scene{.id = named.id};
  const auto read = [](const std::string&, std::string_view value) { return parse_value(value); };
  for (const auto& setting : named.settings) add_setting(setting, scene, read);
  return scene;
}

std::vector<SceneVariant> read_variants(const std::string& text, const std::vector<std::string>& settings,
                                        const SceneRegistry& among) {
  const auto named = split_label(text, settings);
  std::vector<SceneVariant> variants{{.factory = &among.named(named.id)}};
  for (const auto& setting : named.settings) {
    const auto values = values_of(setting);
    if (values.size() * variants.size() > max_variants) {
      reject_text("setting", setting,
                  fmt::format("a range of at most {} scenes with the others", max_variants));
    }
    std::vector<SceneVariant> more;
    for (const auto& variant : variants) {
      for (const auto& value : values) add_setting(value, more.emplace_back(variant));
    }
    variants = std::move(more);
  }
  return variants;
}

SceneVariant parse_variant(const std::string& text, const SceneRegistry& among) {
  return parse_variant(text, {}, among);
}

SceneVariant parse_variant(const std::string& text, const std::vector<std::string>& settings,
                           const SceneRegistry& among) {
  SceneVariant variant = read_variant(text, settings, among);
  require_start_at_zero(make_scene(variant), "runs that are recorded");
  return variant;
}

std::vector<SceneVariant> parse_variants(const std::string& text, const std::vector<std::string>& settings,
                                         const SceneRegistry& among) {
  auto variants = read_variants(text, settings, among);
  for (const auto& variant : variants) require_start_at_zero(make_scene(variant), "runs that are recorded");
  return variants;
}

}  // namespace fde::bench
