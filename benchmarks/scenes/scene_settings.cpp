// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/scene_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace fde::bench {

std::string settings_text(const SceneSettings& scene) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : scene.values) texts.push_back(fmt::format("{}={}", name, to_text(value)));
  if (scene.until) texts.push_back(fmt::format("until={}", *scene.until));
  return fmt::format("{}", fmt::join(texts, ","));
}

std::string label_of(const SceneSettings& scene) {
  const auto settings = settings_text(scene);
  return settings.empty() ? scene.id : fmt::format("{}:{}", scene.id, settings);
}

std::string short_checksum(const SceneSettings& scene) {
  constexpr std::size_t digits = 8;
  return scene.checksum.substr(0, digits);
}

}  // namespace fde::bench
