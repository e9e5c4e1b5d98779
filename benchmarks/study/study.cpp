// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/study/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

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

class StudyReader : StudySettingsReader {
 public:
  StudyReader(const std::string& file, std::string_view text, const SceneRegistry& known)
      : StudySettingsReader(file, text), known_(known) {}

  [[nodiscard]] Study read(const toml::table& all) const {
    require_keys(all, "a study", with_settings({"title", "family"}));
    Study study{.file = file(), .checksum = sha256(text())};
    if (const auto* title = all.get("title")) {
      study.title = text_value(*title, "title");
      if (!is_printable(study.title)) reject(position_of(*title), "title: must be UTF-8 that prints");
    }
    static_cast<void>(settings_of(all, {}));  // also those that every family replaces have to be right
    const auto& families = required(all, {}, "a study", "family");
    std::size_t scenes = 0;
    for (const auto& family : array(families, "family", "tables [[family]]")) {
      study.families.push_back(family_of(family, all));
      scenes += study.families.back().scenes.size();
    }
    if (scenes == 0) reject(position_of(families), "family: is an empty list, must have a family");
    if (scenes > max_study_scenes)
      reject({}, fmt::format("the study has {} scenes: must be at most {}", scenes, max_study_scenes));
    return study;
  }

 private:
  [[nodiscard]] StudyFamily family_of(const toml::node& node, const toml::table& all) const {
    const auto& of = table(node, "family");
    const auto place = position_of(node);
    require_keys(of, "a family", with_settings({"scene", "parameters", "until", "draws", "seed", "points"}));
    StudyFamily family{.position = place, .settings = settings_of(all, of)};
    const auto& scene = required(of, place, "a family", "scene");
    family.scenes = scenes_of(of, place, factory_of(scene));
    return family;
  }

  [[nodiscard]] const SceneFactory& factory_of(const toml::node& node) const {
    const auto name = text_value(node, "scene");
    try {
      return known_.named(name.ends_with(equation_file_extension) ? id_of_file(file(), name) : name);
    } catch (const std::invalid_argument& wrong) {
      reject(position_of(node), wrong.what());
    }
  }

  const SceneRegistry& known_;
};

std::string value_text(const ParameterValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return toml_text(*word);
  if (std::holds_alternative<double>(value)) return to_text(value);
  return fmt::format("[{}]", to_text(value));
}

std::string point_text(const SceneVariant& scene) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : scene.values)
    parts.push_back(fmt::format("{} = {}", toml_key(name), value_text(value)));
  if (scene.until) parts.push_back(fmt::format("until = {}", *scene.until));
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

std::string scene_text(const SceneFactory& factory, const std::filesystem::path& folder) {
  const bool is_file = factory.id.ends_with(equation_file_extension);
  return is_file ? std::filesystem::relative(factory.id, folder).string() : factory.id;
}

std::string text_of(const StudyFamily& family, const std::filesystem::path& folder) {
  auto text = fmt::format("\n[[family]]\nscene = {}\n",
                          toml_text(scene_text(*family.scenes.front().factory, folder)));
  text += text_of(family.settings);
  text += "points = [\n";
  for (const auto& scene : family.scenes) text += fmt::format("  {},\n", point_text(scene));
  return text + "]\n";
}

Sweep sweep_of(const Study& study, const StudyFamily& family, bool examine, bool undisturbed) {
  auto request = family.settings.request;
  request.scenes = family.scenes;
  request.examine = examine;
  request.undisturbed = undisturbed;
  try {
    Sweep sweep = std::move(sweeps_of(request).front());
    sweep.describes_solutions = false;
    return sweep;
  } catch (const Refusal& refusal) {
    if (refusal.field() == "examine" || refusal.field() == "undisturbed") throw;
    reject_settings(refusal, family.settings, study.file, family.position);
  }
}

}  // namespace

Study read_study(const std::filesystem::path& file, const SceneRegistry& known) {
  const auto name = file.string();
  const auto text = read_text_file(file, max_study_bytes);
  const auto all = parse_toml(name, text);
  return StudyReader(name, text, known).read(all);
}

std::string text_of(const Study& study, const std::filesystem::path& folder) {
  std::string text = study.title.empty() ? "" : fmt::format("title = {}\n", toml_text(study.title));
  for (const auto& family : study.families) text += text_of(family, folder);
  return text;
}

std::vector<Sweep> sweeps_of(const Study& study, bool examine, bool undisturbed) {
  std::vector<Sweep> sweeps;
  std::map<std::string, std::size_t> with_settings;  // the sweep with the settings of this text
  for (const auto& family : study.families) {
    if (family.scenes.empty()) continue;  // a request without scenes takes all
    const auto [place, is_new] = with_settings.try_emplace(text_of(family.settings), sweeps.size());
    if (is_new) {
      sweeps.push_back(sweep_of(study, family, examine, undisturbed));
    } else {
      std::ranges::copy(family.scenes, std::back_inserter(sweeps[place->second].scenes));
    }
  }
  return sweeps;
}

}  // namespace fde::bench
