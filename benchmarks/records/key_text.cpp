// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/key_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <variant>
#include <vector>

namespace fde::bench {

using Json = nlohmann::json;

Json number_of(double value) {
  constexpr double largest_exact = 9e15;  // every whole number up to it is a double
  const bool is_whole = value == std::trunc(value) && std::abs(value) < largest_exact;
  if (is_whole && !(value == 0.0 && std::signbit(value))) return static_cast<std::int64_t>(value);
  return value;
}

Json json_of(const SceneSettings& scene) {
  Json line{{"scene", scene.id}};
  if (!scene.checksum.empty()) line["checksum"] = scene.checksum;
  for (const auto& [name, setting] : scene.values)
    std::visit([&, &of = name](const auto& value) { line["settings"][of] = value; }, setting);
  if (scene.until) line["settings"]["until"] = *scene.until;
  return line;
}

SceneSettings scene_of(const Json& line) {
  SceneSettings scene{.id = line.at("scene")};
  if (line.contains("checksum")) scene.checksum = line["checksum"].get<std::string>();
  if (line.contains("checksum") && scene.checksum.empty())
    throw std::invalid_argument("checksum = : must be a SHA-256 in hexadecimal");
  if (!line.contains("settings")) return scene;
  for (const auto& [name, value] : line["settings"].get_ref<const Json::object_t&>()) {
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

Json json_of(const Tolerance& accuracy) { return {{"relative", accuracy.rtol}, {"absolute", accuracy.atol}}; }

Tolerance tolerance_of(const Json& accuracy) {
  return {.rtol = accuracy.at("relative"), .atol = accuracy.at("absolute")};
}

int steps_of(const Json& line, int fewest) {
  constexpr int most = std::numeric_limits<int>::max();
  const auto& given = line.at("steps");
  if (given.is_number_integer() && given >= fewest && given <= most) return given;
  throw std::invalid_argument(
      fmt::format("steps = {}: must be a whole number from {} to {}", given.dump(), fewest, most));
}

Json json_of(const RunKey& run) {
  const RunSettings usual;
  const auto& [resolution, grading, history, newton_tolerance, budget] = run.settings;
  Json line = json_of(run.scene);
  line["scheme"] = run.scheme;
  if (run.external) line["external"] = true;
  if (const auto* steps = std::get_if<int>(&resolution)) line["steps"] = *steps;
  if (const auto* accuracy = std::get_if<Tolerance>(&resolution)) line["accuracy"] = json_of(*accuracy);
  if (grading != usual.grading) line["grid"] = grid_text(grading);
  if (history != usual.history) line["history"] = name(history);
  if (newton_tolerance != usual.newton_tolerance) line["tolerance"] = newton_tolerance;
  if (budget != usual.budget) line["budget"] = number_of(budget);
  return line;
}

RunKey run_of(const Json& line) {
  RunKey run{.scene = scene_of(line), .scheme = line.at("scheme"), .external = line.value("external", false)};
  RunSettings& settings = run.settings;
  if (line.contains("accuracy")) {
    settings.resolution = tolerance_of(line["accuracy"]);
  } else {
    settings.resolution = steps_of(line, 1);
  }
  if (line.contains("grid")) settings.grading = parse_grading(line["grid"].get<std::string>());
  if (line.contains("history")) settings.history = parse_history(line["history"].get<std::string>());
  settings.newton_tolerance = line.value("tolerance", settings.newton_tolerance);
  settings.budget = line.value("budget", settings.budget);
  return run;
}

}  // namespace fde::bench
