// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/external/task_text.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

namespace fde::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;

// All parameters, defaults included. One that follows from others is given as its formula.
Json parameters_of(const SceneVariant& variant) {
  Json parameters = Json::object();
  for (const Parameter& parameter : variant.maker->parameters) {
    const auto found = variant.values.find(parameter.name);
    const ParameterValue& value = found == variant.values.end() ? parameter.value : found->second;
    std::visit([&](const auto& of) { parameters[parameter.name] = of; }, value);
  }
  return parameters;
}

Json rows_of(const Problem& problem) {
  Json rows = Json::array();
  for (const Component& component : problem.components) {
    rows.push_back({{"order", component.order},
                    {"initial", component.initial},
                    {"side", component.side == Side::left ? "left" : "right"}});
  }
  return rows;
}

Json equations_of(const std::vector<EquationFormula>& equations) {
  Json all = Json::array();
  for (const auto& [unknown, terms, rhs, initial] : equations) {
    Json of_unknown = Json::array();
    for (const auto& [coefficient, order] : terms) of_unknown.push_back({coefficient, order});
    all.push_back({{"unknown", unknown}, {"terms", of_unknown}, {"rhs", rhs}, {"initial", initial}});
  }
  return all;
}

}  // namespace

std::string task_json(const SceneVariant& variant, const Scene& scene, const RunSettings& setup,
                      const std::vector<double>& times) {
  Json task{{"format", format},
            {"scene", variant.maker->id},
            {"label", variant.label()},
            {"parameters", parameters_of(variant)},
            {"rows", rows_of(scene.problem)},
            {"columns", scene.outputs.names},
            {"end_time", scene.problem.end},
            {"steps", std::get<int>(setup.resolution)},
            {"grid", grid_text(setup.grading)},
            {"times", times}};
  if (!variant.maker->equations.empty()) task["equations"] = equations_of(variant.maker->equations);
  if (!scene.problem.jump_times.empty()) task["jumps"] = scene.problem.jump_times;
  if (std::isfinite(setup.budget)) task["budget"] = setup.budget;
  return task.dump(1) + '\n';
}

}  // namespace fde::bench
