// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fdebench/benchmarks/scenes/equation_file_name.hpp"
#include "fdebench/benchmarks/study/study.hpp"

namespace fde::bench {
namespace {

// In double quotes; TOML has the escapes of JSON.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string key_text(const std::string& name) {
  constexpr std::string_view bare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return name.find_first_not_of(bare) == std::string::npos && !name.empty() ? name : quoted(name);
}

std::string value_text(const ParameterValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return quoted(*word);
  if (std::holds_alternative<double>(value)) return to_text(value);
  return fmt::format("[{}]", to_text(value));
}

std::string point_text(const SceneVariant& scene) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : scene.values)
    parts.push_back(fmt::format("{} = {}", key_text(name), value_text(value)));
  if (scene.until) parts.push_back(fmt::format("until = {}", *scene.until));
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

std::string setting_text(const StudyKey& kind, const std::vector<std::string>& texts) {
  std::vector<std::string> parts;
  for (const auto& text : texts) {
    const auto equals = text.find('=');
    parts.push_back(kind.key == "external" ? fmt::format("{} = {}", key_text(text.substr(0, equals)),
                                                         quoted(text.substr(equals + 1)))
                    : kind.is_text         ? quoted(text)
                                           : text);
  }
  const auto list = fmt::format("{}", fmt::join(parts, ", "));
  if (kind.key == "external") return fmt::format("external = {{{}}}\n", list);
  return kind.is_list ? fmt::format("{} = [{}]\n", kind.key, list) : fmt::format("{} = {}\n", kind.key, list);
}

std::string scene_text(const SceneFactory& maker, const std::filesystem::path& folder) {
  const bool is_file = maker.id.ends_with(equation_file_extension);
  return is_file ? std::filesystem::relative(maker.id, folder).string() : maker.id;
}

std::string text_of(const StudyFamily& family, const std::filesystem::path& folder) {
  auto text =
      fmt::format("\n[[family]]\nscene = {}\n", quoted(scene_text(*family.scenes.front().maker, folder)));
  for (const auto& kind : study_keys) {
    const auto setting = family.settings.find(std::string(kind.key));
    if (setting != family.settings.end()) text += setting_text(kind, setting->second.texts);
  }
  text += "points = [\n";
  for (const auto& scene : family.scenes) text += fmt::format("  {},\n", point_text(scene));
  return text + "]\n";
}

}  // namespace

std::string text_of(const Study& study, const std::filesystem::path& folder) {
  std::string text = study.title.empty() ? "" : fmt::format("title = {}\n", quoted(study.title));
  for (const auto& family : study.families) text += text_of(family, folder);
  return text;
}

}  // namespace fde::bench
