// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/answers_json.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>
#include <variant>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t few_names = 16;

// The list of names; many consecutive names u1, u2, ... as a pattern with a range.
Json names_json(const std::vector<std::string>& names) {
  if (names.size() <= few_names) return names;
  const std::string& first = names.front();
  const auto prefix = first.substr(0, first.find_last_not_of("0123456789") + 1);
  const auto number = try_parse_number(first.substr(prefix.size()));
  if (!number) return names;
  const auto from = static_cast<std::size_t>(*number);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] != fmt::format("{}{}", prefix, from + i)) return names;
  }
  return {{"pattern", prefix + "{i}"}, {"from", from}, {"to", from + names.size() - 1}};
}

Json parameter_json(const Parameter& parameter) {
  const auto as_json = [](const auto& value) -> Json { return value; };
  return {{"name", parameter.name},
          {"default", std::visit(as_json, parameter.value)},
          {"allowed", parameter.allowed()},
          {"meaning", parameter.description}};
}

}  // namespace

std::vector<std::string> defined_by(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.reference.at) names.emplace_back("exact");
  if (has_jacobian(scene.problem)) names.emplace_back("jacobian");
  if (is_linear(scene.problem)) names.emplace_back("linear");
  if (scene.energy) names.emplace_back("energy");
  if (scene.constraint) names.emplace_back("constraint");
  return names;
}

Json json_of(const SceneFactory& factory) {
  const Scene scene = make_scene(factory);
  Json parameters = Json::array();
  for (const auto& parameter : factory.parameters) parameters.push_back(parameter_json(parameter));
  return {{"id", factory.id},         {"title", factory.title},
          {"source", factory.source}, {"parameters", parameters},
          {"end", end_time(scene)},   {"columns", names_json(scene.outputs.names)},
          {"has", defined_by(scene)}, {"reference", evidence_of(scene)}};
}

Json json_of(const FittedScene& fitted) {
  Json parameters = Json::array(), correlation = Json::array(), columns = Json::array();
  for (const FittedParameter& one : fitted.parameters) {
    const auto unless_at_limit = [&](double value) { return one.is_at_limit ? Json() : Json(value); };
    parameters.push_back({{"name", one.name},
                          {"value", one.value},
                          {"standard_error", unless_at_limit(one.standard_error)},
                          {"low", unless_at_limit(one.low)},
                          {"high", unless_at_limit(one.high)},
                          {"solver_error", unless_at_limit(one.solver_error)},
                          {"at_limit", one.is_at_limit}});
  }
  for (const auto& row : fitted.correlation.rowwise())
    correlation.push_back(std::vector<double>(row.begin(), row.end()));
  const bool estimated = fitted.measured.deviations.size() == 0;
  for (std::size_t c = 0; c < fitted.names.size(); ++c) {
    columns.push_back(
        {{"name", fitted.names[c]},
         {"measurements", fitted.misfits[c].count},
         {"rms", fitted.misfits[c].rms()},
         {"deviation", estimated ? Json(fitted.deviations(static_cast<Eigen::Index>(c), 0)) : Json()}});
  }
  Json made{{"scene", fitted.variant.label()},
            {"parameters", parameters},
            {"correlation", correlation},
            {"columns", columns}};
  if (!estimated) {
    made["chi_squared"] = fitted.chi_squared.value;
    made["degrees_of_freedom"] = fitted.chi_squared.degrees;
    made["probability"] = fitted.chi_squared.probability() ? Json(*fitted.chi_squared.probability()) : Json();
  }
  made.update({{"scheme", fitted.scheme},
               {"accuracy", fitted.accuracy},
               {"solver_error_by", fitted.by_reference ? "reference" : "accuracy"},
               {"solves", fitted.solves},
               {"iterations", fitted.iterations}});
  return made;
}

Json needs_of(const Scheme& scheme) {
  return {{"implicit", scheme.capabilities.implicit},
          {"algebraic_rows", scheme.capabilities.algebraic_rows},
          {"uniform_grid", scheme.capabilities.uniform_grid},
          {"largest_order", scheme.capabilities.max_order},
          {"two_sided", scheme.capabilities.is_two_sided},
          {"takes_grid", !scheme.capabilities.is_adaptive()},
          {"takes_accuracy", scheme.capabilities.is_adaptive()},
          {"discretises_equations", scheme.capabilities.discretises_equations},
          {"checkpoints", scheme.capabilities.checkpoints},
          {"start_weights", bool(scheme.starting_powers)}};
}

Json json_of(const Scheme& scheme) {
  Json facts{{"id", scheme.id}, {"title", scheme.title}, {"source", scheme.source}};
  if (!scheme.alias.empty()) facts["other_name"] = scheme.alias;
  facts.update(needs_of(scheme));
  return facts;
}

nlohmann::ordered_json json_of(const SolveCost& cost) {
  nlohmann::ordered_json shown{{"seconds", cost.seconds}};
  const auto add = [&shown](const char* key, const auto& count) {
    if (count) shown[key] = *count;
  };
  const auto add_text = [&shown](const char* key, std::string_view text) {
    if (!text.empty()) shown[key] = std::string(text);
  };
  const Cost& of_scheme = cost.of_scheme;
  add("rhs", of_scheme.rhs_calls);
  add("newton", of_scheme.newton_iterations);
  add_text("grid", cost.grid);
  if (of_scheme.history) {
    add_text("history", name(of_scheme.history->kind));
    if (of_scheme.history->for_memory) add_text("history_chosen_for", "memory");
  }
  add("history_bytes", of_scheme.history_bytes);
  add("states", of_scheme.components);
  add_text("linear_solver", of_scheme.linear_solver);
  add("start_weights", of_scheme.starting_weights);
  add("rejected_steps", of_scheme.rejected_steps);
  if (cost.checkpoints) {
    shown["continued"] = cost.checkpoints->continued;
    shown["checkpoints"] = cost.checkpoints->count;
    shown["checkpoint_bytes"] = cost.checkpoints->bytes;
    shown["checkpoint_seconds"] = cost.checkpoints->seconds;
  }
  add("expected_rate", cost.expected_rate);
  return shown;
}

}  // namespace fde::bench
