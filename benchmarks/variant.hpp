#pragma once

#include <map>
#include <optional>
#include <string>

#include "scene.hpp"

namespace fde {

// A scene with some parameters, or its end, replaced. In results and on the command line:
// "pendulum:alpha=1.9,beta=0.1,until=100".
struct SceneVariant {
  const SceneMaker* maker;
  std::map<std::string, double> values{};
  std::optional<double> until{};  // the end of the time interval

  [[nodiscard]] std::string label() const;
};

// The scene made from its defaults with some values replaced.
Scene make_scene(const SceneMaker& maker, const std::map<std::string, double>& values = {});

// The same, up to the end that the variant gives. Throws std::invalid_argument where the scene is posed at
// both ends and has another.
Scene make_scene(const SceneVariant& variant);

}  // namespace fde
