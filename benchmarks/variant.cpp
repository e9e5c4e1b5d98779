#include "variant.hpp"

#include <fmt/format.h>

namespace fde {

std::string SceneVariant::label() const {
  std::string text(maker->id);
  const auto add = [&](std::string_view name, const std::string& value) {
    text += fmt::format("{}{}={}", text.size() == maker->id.size() ? ':' : ',', name, value);
  };
  for (const auto& [name, value] : values)
    add(name, parameter_named(name, maker->id, maker->parameters).text_of(value));
  if (until) add("until", fmt::format("{}", *until));
  return text;
}

Scene make_scene(const SceneMaker& maker, const std::map<std::string, double>& values) {
  const Parameters parameters(maker.id, maker.parameters, values);
  Scene scene = maker.make(parameters);
  scene.name = fmt::format("{} {}", maker.id, parameters.text());
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

}  // namespace fde
