// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "fdebench/reports/analysis/recommendation.hpp"

namespace fde::bench {
namespace {

nlohmann::json json_of(const Configuration& configuration, int steps) {
  return {{"scheme", configuration.scheme->id}, {"grid", grid_text(configuration.grading)}, {"steps", steps}};
}

nlohmann::json json_of(const ErrorEstimate& estimate) {
  return {{"missing", estimate.no_reference_reason},
          {"runs",
           {json_of(estimate.first, estimate.first_steps), json_of(estimate.second, estimate.second_steps)}},
          {"difference", estimate.difference},
          {"error", estimate.error()}};
}

}  // namespace

std::string json_of(const Recommendation& made) {
  using Json = nlohmann::json;
  const RecommendedRun& first = made.options.front();
  const auto* second = runner_up(made);
  Json json{{"scene", label_of(made.scene)},
            {"scheme", first.schemes.front()},
            {"same_as", std::vector(first.schemes.begin() + 1, first.schemes.end())},
            {"grid", nullptr},
            {"asked", nullptr},
            {"steps", first.steps},
            {"norm", name(made.kind.norm)},
            {"scale", name(made.kind.scale)},
            {"accuracy", made.accuracy},
            {"error", first.error},
            {"predicted_error", nullptr},
            {"seconds", first.time.median},
            {"seconds_low", first.time.low},
            {"seconds_high", first.time.high},
            {"within_noise", within_noise(made)},
            {"runner_up", nullptr},
            {"factor", nullptr},
            {"command", nullptr}};
  if (const auto* accuracy = std::get_if<Tolerance>(&first.setup.resolution)) {
    json["asked"] = accuracy->rtol;
  } else {
    json["grid"] = grid_text(first.setup.grading);
  }
  if (!first.external) json["command"] = command_of(made.scene, first);
  if (made.estimate) {
    json["estimated"] = true;
    json["estimate"] = json_of(*made.estimate);
  }
  if (first.setup_seconds > 0.0) json["once_seconds"] = first.setup_seconds;
  json["runs"] = made.first_run ? "1" : "many";
  if (!first.wall_clock) json["first_run_seconds"] = first_run_seconds(made, first);
  if (made.constant) json["constant"] = true;
  if (first.wall_clock) json["wall_clock"] = true;
  if (first.predicted_error) json["predicted_error"] = *first.predicted_error;
  if (!made.columns.empty()) json["columns"] = made.columns;
  if (second != nullptr) {
    json["runner_up"] = second->schemes.front();
    json["factor"] = second->time.median / first.time.median;
  }
  return json.dump() + '\n';
}

}  // namespace fde::bench
