// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/description_text.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "fdebench/benchmarks/records/key_text.hpp"

namespace fde::bench {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DisplayEquation, left, right)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DescribedParameter, name, value, meaning, given)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Discontinuity, parameter, limit)

namespace {

using Json = nlohmann::json;

constexpr std::array parts{std::pair{"energy", &SampledSolution::energy},
                           std::pair{"reactions", &SampledSolution::reactions},
                           std::pair{"motion", &SampledSolution::motion}};

Json values_of(const std::vector<std::optional<double>>& column) {
  constexpr double largest = 1e300;
  Json values = Json::array();
  for (const auto& value : column)
    values.push_back(value && std::abs(*value) <= largest ? Json(*value) : Json());
  return values;
}

Json json_of(const SampledColumns& columns) {
  Json sampled{{"columns", columns.names}};
  for (const auto& column : columns.values) sampled["values"].push_back(values_of(column));
  return sampled;
}

SampledColumns columns_of(const Json& sampled) {
  SampledColumns columns{.names = sampled.at("columns")};
  for (const auto& values : sampled.value("values", Json::array())) {
    auto& column = columns.values.emplace_back();
    for (const auto& value : values)
      column.push_back(value.is_null() ? std::nullopt : std::optional(value.get<double>()));
  }
  return columns;
}

SampledSolution solution_of(const Json& sampled) {
  SampledSolution solution{
      .t = sampled.at("t"), .columns = columns_of(sampled), .bound = sampled.at("bound")};
  for (const auto& [name, part] : parts) {
    if (sampled.contains(name)) solution.*part = columns_of(sampled[name]);
  }
  return solution;
}

Json json_of(const TrialRuns& trial) {
  return {{"number", trial.number},
          {"kind", trial.kind},
          {"steps", trial.steps},
          {"accuracy", bench::json_of(trial.accuracy)}};
}

TrialRuns trial_of(const Json& trial) {
  return {.number = trial.at("number"),
          .kind = trial.at("kind"),
          .steps = trial.at("steps"),
          .accuracy = tolerance_of(trial.at("accuracy"))};
}

}  // namespace

Json json_of(const SampledSolution& solution) {
  Json sampled = json_of(solution.columns);
  sampled["t"] = solution.t;
  sampled["bound"] = solution.bound;
  for (const auto& [name, part] : parts) {
    if (!(solution.*part).names.empty()) sampled[name] = json_of(solution.*part);
  }
  return sampled;
}

Json json_of(const SceneDescription& scene) {
  Json fields = json_of(scene.scene);
  fields["title"] = scene.title;
  fields["source"] = scene.source;
  fields["equations"] = scene.equations;
  fields["parameters"] = scene.parameters;
  fields["discontinuities"] = scene.discontinuities;
  fields["evidence"] = scene.evidence;
  if (scene.reference_seconds) fields["reference_seconds"] = *scene.reference_seconds;
  if (scene.trial) fields["trial"] = json_of(*scene.trial);
  if (scene.solution) fields["solution"] = json_of(*scene.solution);
  return fields;
}

SceneDescription description_of(const Json& fields) {
  SceneDescription scene{.scene = scene_of(fields),
                         .title = fields.at("title"),
                         .source = fields.value("source", ""),
                         .equations = fields.value("equations", std::vector<DisplayEquation>()),
                         .parameters = fields.value("parameters", std::vector<DescribedParameter>()),
                         .discontinuities = fields.value("discontinuities", std::vector<Discontinuity>()),
                         .evidence = fields.value("evidence", "")};
  if (fields.contains("reference_seconds")) scene.reference_seconds = fields["reference_seconds"];
  if (fields.contains("trial")) scene.trial = trial_of(fields["trial"]);
  if (fields.contains("solution")) scene.solution = solution_of(fields["solution"]);
  return scene;
}

}  // namespace fde::bench
