// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/recorded_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <vector>

#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/reports/analysis/scene_numbers.hpp"

namespace fde::bench {
namespace {

bool same_name(SceneSettings scene, const SceneSettings& requested) {
  scene.checksum = requested.checksum;
  return scene == requested;
}

// The scene that is named; nullopt if its equation file does not exist or, of a scene with runs, if this
// build does not have it.
std::optional<SceneSettings> known_scene(const std::set<SceneSettings>& scenes, const std::string& text,
                                         const std::vector<std::string>& settings,
                                         const SceneSettings& unread, const SceneRegistry& known) {
  const auto file = equation_file_of_label(text);
  if (file && !std::filesystem::exists(*file)) return std::nullopt;
  try {
    return read_variant(text, settings, known).key();
  } catch (const std::invalid_argument&) {
    const bool has_runs =
        std::ranges::any_of(scenes, [&](const auto& one) { return same_name(one, unread); });
    if (file || !has_runs) throw;
    return std::nullopt;
  }
}

}  // namespace

SceneSettings recorded_scene(const Runs& runs, const std::string& results, const std::string& text,
                             const std::vector<std::string>& settings, const SceneRegistry& known,
                             const std::string& any) {
  std::set<SceneSettings> scenes;
  for (const auto& scene : scenes_of(runs)) scenes.insert(without(scene, any));
  const auto unread = without(read_settings(text, settings), any);
  const auto found_scene = known_scene(scenes, text, settings, unread, known);
  const SceneSettings requested = found_scene ? without(*found_scene, any) : unread;
  std::vector<SceneSettings> found;
  const SceneSettings* other = nullptr;
  for (const auto& scene : scenes) {
    if (!same_name(scene, requested)) continue;
    const bool is_requested = !found_scene || scene.checksum == requested.checksum;
    is_requested ? found.push_back(scene) : void(other = &scene);
  }
  if (found.size() == 1) return found.front();
  throw std::invalid_argument(fmt::format(
      "--results = {}: has {} {}{}", results,
      found.empty() ? "no run of" : "runs of more than one file that was", label_of(requested),
      other == nullptr
          ? ""
          : fmt::format(" as it is, only of another file of this name ({})", short_checksum(*other))));
}

}  // namespace fde::bench
