// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <string>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

std::string value_text(const Parameter& parameter, const SceneSettings& scene) {
  const auto given = scene.values.find(parameter.name);
  if (given != scene.values.end()) return to_text(given->second);
  return parameter.default_formula.empty() ? to_text(parameter.value) : parameter.default_formula;
}

}  // namespace

// The formulas as text; the page typesets them.
json equations_of(const SceneSettings& scene) {
  json all = json::array();
  const SceneFactory* maker = find_scene(scene.id);
  if (maker == nullptr) return all;
  const bool has_statements = !maker->display_equations.empty();
  for (const auto& [unknown, terms, rhs, initial] : maker->equations) {
    if (has_statements) break;
    json of_unknown = json::array();
    for (const auto& [coefficient, order] : terms) of_unknown.push_back({coefficient, order});
    all.push_back({{"unknown", unknown}, {"terms", of_unknown}, {"rhs", rhs}});
  }
  for (const auto& [left, right] : maker->display_equations)
    all.push_back({{"left", left}, {"right", right}});
  return all;
}

json parameters_of(const SceneSettings& scene) {
  json all = json::array();
  const SceneFactory* maker = find_scene(scene.id);
  if (maker == nullptr) return all;
  for (const Parameter& parameter : maker->parameters) {
    all.push_back({{"name", parameter.name},
                   {"value", value_text(parameter, scene)},
                   {"meaning", parameter.description},
                   {"given", scene.values.contains(parameter.name)}});
  }
  return all;
}

}  // namespace fde::bench
