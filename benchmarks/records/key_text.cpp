// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/key_text.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <variant>
#include <vector>

namespace fde::bench {

using Json = nlohmann::json;

Json json_of(const SceneSettings& scene) {
  Json settings = Json::object();
  for (const auto& [name, setting] : scene.values)
    std::visit([&, &of = name](const auto& value) { settings[of] = value; }, setting);
  if (scene.until) settings["until"] = *scene.until;
  Json line{{"scene", scene.id}, {"settings", std::move(settings)}};
  if (!scene.checksum.empty()) line["checksum"] = scene.checksum;
  return line;
}

SceneSettings scene_of(const Json& line) {
  SceneSettings scene{.id = line.at("scene")};
  if (line.contains("checksum")) scene.checksum = line["checksum"].get<std::string>();
  if (line.contains("checksum") && scene.checksum.empty())
    throw std::invalid_argument("checksum = : must be a SHA-256 in hexadecimal");
  for (const auto& [name, value] : line.at("settings").items()) {
    if (name == "until") {
      scene.until = value.get<double>();
    } else if (value.is_string()) {
      scene.values.emplace(name, value.get<std::string>());
    } else if (value.is_array()) {
      scene.values.emplace(name, value.get<std::vector<double>>());
    } else {
      scene.values.emplace(name, value.get<double>());
    }
  }
  return scene;
}

}  // namespace fde::bench
