// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/study/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "fdebench/benchmarks/equation_files/toml_text.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/study/study_points.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {

namespace {

constexpr std::size_t max_study_bytes = std::size_t{1} << 26;

// The path from the current folder of a file below it, otherwise its absolute path: the same of a study and
// of its parts in other folders.
std::string id_of_file(const std::filesystem::path& study, const std::string& scene) {
  const auto path = std::filesystem::weakly_canonical(std::filesystem::absolute(study).parent_path() / scene);
  auto below = path.lexically_relative(std::filesystem::current_path());
  return (below.empty() || *below.begin() == ".." ? path : below).string();
}

class StudyReader : StudyPoints {
 public:
  StudyReader(const std::string& file, std::string_view text, const SceneRegistry& known)
      : StudyPoints(file, text), known_(known) {}

  [[nodiscard]] Study read(const toml::table& all) const {
    require_keys(all, "a study", with_settings({"title", "family"}));
    Study study{.file = file(), .checksum = sha256(text())};
    if (const auto* title = all.get("title")) {
      study.title = text_value(*title, "title");
      if (!is_printable(study.title)) reject(position_of(*title), "title: must be UTF-8 that prints");
    }
    const StudySettings shared = settings_of(all);
    const auto& families = required(all, {}, "a study", "family");
    std::size_t scenes = 0;
    for (const auto& family : array(families, "family", "tables [[family]]")) {
      study.families.push_back(family_of(family, shared));
      scenes += study.families.back().scenes.size();
    }
    if (scenes == 0) reject(position_of(families), "family: is an empty list, must have a family");
    if (scenes > max_study_scenes)
      reject({}, fmt::format("the study has {} scenes: must be at most {}", scenes, max_study_scenes));
    return study;
  }

 private:
  static std::vector<std::string_view> with_settings(std::vector<std::string_view> keys) {
    for (const auto& one : study_keys) keys.push_back(one.key);
    return keys;
  }

  [[nodiscard]] StudyFamily family_of(const toml::node& node, const StudySettings& shared) const {
    const auto& of = table(node, "family");
    const auto place = position_of(node);
    require_keys(of, "a family", with_settings({"scene", "parameters", "until", "draws", "seed", "points"}));
    StudyFamily family{.position = place, .settings = settings_of(of)};
    family.settings.insert(shared.begin(), shared.end());
    const auto& scene = required(of, place, "a family", "scene");
    family.scenes = scenes_of(of, place, maker_of(scene));
    return family;
  }

  [[nodiscard]] const SceneFactory& maker_of(const toml::node& node) const {
    const auto name = text_value(node, "scene");
    try {
      return known_.named(name.ends_with(equation_file_extension) ? id_of_file(file(), name) : name);
    } catch (const std::invalid_argument& wrong) {
      reject(position_of(node), wrong.what());
    }
  }

  [[nodiscard]] StudySettings settings_of(const toml::table& of) const {
    StudySettings settings;
    for (const auto& kind : study_keys) {
      if (const auto* node = of.get(kind.key))
        settings.emplace(kind.key, StudySetting{texts_of(*node, kind), position_of(*node)});
    }
    return settings;
  }

  [[nodiscard]] std::vector<std::string> texts_of(const toml::node& node, const StudyKey& kind) const {
    std::vector<std::string> texts;
    if (kind.key == "external") {
      for (const auto& entry : entries(node, kind.key))
        texts.push_back(fmt::format("{}={}", entry.name, text_value(*entry.node, entry.name)));
      return texts;
    }
    const auto* list = node.as_array();
    if (!kind.is_list || list == nullptr) return {setting_text(node, kind)};
    for (const auto& one : *list) texts.push_back(setting_text(one, kind));
    if (texts.empty())
      reject(position_of(node), fmt::format("{}: is an empty list, must have a value", kind.key));
    return texts;
  }

  [[nodiscard]] std::string setting_text(const toml::node& node, const StudyKey& kind) const {
    // A whole number may be too large for a double: the option says so.
    if (const auto* whole = node.as_integer(); whole != nullptr && !kind.is_text)
      return fmt::format("{}", whole->get());
    if (!kind.is_text) return fmt::format("{}", number_value(node, kind.key));
    return text_value(node, kind.key);
  }

  const SceneRegistry& known_;
};

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

std::string scene_text(const SceneFactory& factory, const std::filesystem::path& folder) {
  const bool is_file = factory.id.ends_with(equation_file_extension);
  return is_file ? std::filesystem::relative(factory.id, folder).string() : factory.id;
}

std::string text_of(const StudyFamily& family, const std::filesystem::path& folder) {
  auto text =
      fmt::format("\n[[family]]\nscene = {}\n", quoted(scene_text(*family.scenes.front().factory, folder)));
  for (const auto& kind : study_keys) {
    const auto setting = family.settings.find(std::string(kind.key));
    if (setting != family.settings.end()) text += setting_text(kind, setting->second.texts);
  }
  text += "points = [\n";
  for (const auto& scene : family.scenes) text += fmt::format("  {},\n", point_text(scene));
  return text + "]\n";
}

}  // namespace

Study read_study(const std::filesystem::path& file, const SceneRegistry& known) {
  const auto name = file.string();
  const auto text = read_text_file(file, max_study_bytes);
  const auto all = parse_toml(name, text);
  return StudyReader(name, text, known).read(all);
}

std::string text_of(const Study& study, const std::filesystem::path& folder) {
  std::string text = study.title.empty() ? "" : fmt::format("title = {}\n", quoted(study.title));
  for (const auto& family : study.families) text += text_of(family, folder);
  return text;
}

}  // namespace fde::bench
