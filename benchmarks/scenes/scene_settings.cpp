#include "scenes/scene_settings.hpp"

#include <fmt/format.h>

namespace fde {

std::string settings_text(const SceneSettings& scene) {
  std::string text;
  const auto add = [&](const std::string& name, const auto& value) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", name, value);
  };
  for (const auto& [name, setting] : scene.values)
    std::visit([&, &of = name](const auto& value) { add(of, value); }, setting);
  if (scene.until) add("until", *scene.until);
  return text;
}

std::string label_of(const SceneSettings& scene) {
  const auto settings = settings_text(scene);
  return settings.empty() ? scene.id : fmt::format("{}:{}", scene.id, settings);
}

}  // namespace fde
