// SPDX-License-Identifier: MIT
#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "fdebench/benchmarks/requests/answers_json.hpp"

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

// Sets `asked`, the tolerance of a run with adaptive step size, or `grid`; the other one is null.
void set_resolution(nlohmann::json& json, const RunSettings& settings) {
  const auto* accuracy = std::get_if<Tolerance>(&settings.resolution);
  json["asked"] = accuracy != nullptr ? nlohmann::json(accuracy->rtol) : nlohmann::json();
  json["grid"] = accuracy != nullptr ? nlohmann::json() : nlohmann::json(grid_text(settings.grading));
}

// Sets the values by the measures of the caller, if there are any.
void set_measured(nlohmann::json& json, const RecommendedRun& run) {
  for (const auto& [measure, value] : run.measured) json["measures"][std::string(measure)] = value;
}

// What was run, what it takes and delivers; null where a scheme has no run, or none to its end.
nlohmann::json json_of(const RecommendedRun& option, const std::string& outcome) {
  nlohmann::json json{
      {"scheme", option.schemes.front()}, {"steps", nullptr},  {"error", nullptr}, {"seconds", nullptr},
      {"first_run_seconds", nullptr},     {"outcome", outcome}};
  set_resolution(json, option.settings);
  if (option.steps == 0) return json;
  json["steps"] = option.steps;
  if (std::isfinite(option.error)) json["error"] = option.error;
  json["seconds"] = option.later_run_seconds();
  json["first_run_seconds"] = option.first_run_seconds();
  set_measured(json, option);
  return json;
}

nlohmann::json others_of(const Recommendation& made) {
  nlohmann::json all = nlohmann::json::array();
  for (const RecommendedRun& option : made.options)
    if (&option != &made.options.front()) all.push_back(json_of(option, "within"));
  for (const RejectedScheme& scheme : made.rejected) all.push_back(json_of(scheme.finest, scheme.reason));
  return all;
}

}  // namespace

nlohmann::json json_of(const Recommendation& made) {
  using Json = nlohmann::json;
  const RecommendedRun& first = made.options.front();
  const auto* second = runner_up(made);
  Json json{{"scene", label_of(made.scene)},
            {"scheme", first.schemes.front()},
            {"same_as", std::vector(first.schemes.begin() + 1, first.schemes.end())},
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
  set_resolution(json, first.settings);
  set_measured(json, first);
  if (const auto command = command_of(made.scene, first); !command.empty()) json["command"] = command;
  if (made.estimate) {
    json["estimated"] = true;
    json["estimate"] = json_of(*made.estimate);
  }
  if (first.setup_seconds > 0.0) json["once_seconds"] = first.setup_seconds;
  json["runs"] = first.first_run ? "1" : "many";
  if (!first.wall_clock) json["first_run_seconds"] = first.first_run_seconds();
  if (made.constant) json["constant"] = true;
  if (first.wall_clock) json["wall_clock"] = true;
  if (first.predicted_error) json["predicted_error"] = *first.predicted_error;
  if (!made.columns.empty()) json["columns"] = made.columns;
  for (const auto& [name, largest, allowed] : made.small)
    json["coarse"].push_back({{"column", name}, {"largest", largest}, {"allowed", allowed}});
  if (second != nullptr) {
    json["runner_up"] = second->schemes.front();
    json["factor"] = second->time.median / first.time.median;
  }
  json["others"] = others_of(made);
  return json;
}

}  // namespace fde::bench
