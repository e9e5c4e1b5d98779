// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "fdebench/benchmarks/requests/choice.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"

using namespace fde::bench;
using namespace fde::bench::c;

namespace {

constexpr auto choice_handle = "a handle of fdebench_choose";

const nlohmann::json& facts_of(const fdebench_choice* choice) {
  return given("choice", choice, choice_handle).facts;
}

ChoiceRequest request_of(const std::map<std::string, OptionValue>& values) {
  if (!values.contains("error")) throw std::invalid_argument("error is required");
  ChoiceRequest request;
  for (const auto& [name, value] : values) {
    if (name == "error") {
      request.error = real_of(name, value, searched_errors);
    } else if (name == "norm") {
      request.kind.norm = parse_norm(text_of(value));
    } else if (name == "scale") {
      request.kind.scale = parse_scale(text_of(value));
    } else if (name == "columns") {
      request.columns = split_names(text_of(value));
    } else if (name == "max-time") {
      request.seconds = real_of(name, value, searched_seconds);
    } else if (name == "runs") {
      request.first_run = parse_first_run(text_of(value));
    } else {
      reject_text("option", name, "of columns, error, max-time, norm, runs, scale");
    }
  }
  return request;
}

// What is chosen for a scene, with the command that solves it; no command knows a problem of the caller.
nlohmann::json chosen(const FdebenchProblem& problem, const ChoiceRequest& request) {
  if (problem.scene.empty()) return json_of(choose(problem.known, request));
  const SceneRegistry all = with_equation_files(built_in_scenes());
  const auto variant = read_variant(problem.scene, {}, all);
  return json_of(choose(make_scene(variant), request, variant.key()));
}

}  // namespace

int fdebench_choose(const fdebench_problem* problem, const fdebench_options* options,
                    fdebench_choice** choice) {
  return guarded([&] {
    auto& result = given("choice", choice);
    const auto& handle = given("problem", problem, problem_handle);
    auto facts = chosen(handle, request_of(given("options", options, options_handle).values));
    facts["json"] = facts.dump();
    result = std::make_unique<FdebenchChoice>(FdebenchChoice{std::move(facts)}).release();
  });
}

int fdebench_choice_number(const fdebench_choice* choice, const char* fact, double* number) {
  return guarded([&] {
    const auto& facts = facts_of(choice);
    given("number", number) = number_in(facts, text_of("fact", fact));
  });
}

int fdebench_choice_text(const fdebench_choice* choice, const char* fact, const char** text) {
  return guarded([&] {
    const auto& facts = facts_of(choice);
    given("text", text) = text_in(facts, text_of("fact", fact));
  });
}

int fdebench_choice_apply(const fdebench_choice* choice, fdebench_options* options) {
  return guarded([&] {
    const auto& facts = facts_of(choice);
    auto values = given("options", options, options_handle).values;
    for (const char* name :
         {"accuracy", "steps", "grid", "error", "norm", "scale", "columns", "runs", "max-time"})
      values.erase(name);
    if (const double asked = number_in(facts, "asked"); !std::isnan(asked)) {
      values["accuracy"] = asked;
    } else {
      values["steps"] = facts.at("steps").get<long long>();
      values["grid"] = std::string(text_in(facts, "grid"));
    }
    options->values = std::move(values);
  });
}

void fdebench_choice_free(fdebench_choice* choice) { delete choice; }
