// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/described_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/sweep/sampled_solution.hpp"
#include "fdebench/benchmarks/sweep/trials.hpp"

namespace fde::bench {
namespace {

// "coefficient*D(unknown, order)", without a coefficient 1.
std::string text_of(const EquationFormula::Term& term, const std::string& unknown) {
  const auto& [coefficient, order] = term;
  auto derivative = fmt::format("D({}, {})", unknown, order);
  if (coefficient == "1") return derivative;
  const bool is_sum = coefficient.find_first_of("+-", 1) != std::string::npos;
  return fmt::format("{}*{}", is_sum ? fmt::format("({})", coefficient) : coefficient, derivative);
}

// A condition, whose terms all have order 0, is 0 = rhs.
DisplayEquation displayed(const EquationFormula& equation) {
  const auto& [unknown, terms, rhs, initial, final] = equation;
  if (std::ranges::all_of(terms, [](const auto& term) { return term.order == "0"; })) return {"0", rhs};
  std::vector<std::string> sum;
  for (const auto& term : terms) sum.push_back(text_of(term, unknown));
  return {fmt::format("{}", fmt::join(sum, " + ")), rhs};
}

std::vector<DisplayEquation> equations_of(const SceneFactory& factory) {
  if (!factory.display_equations.empty()) return factory.display_equations;
  std::vector<DisplayEquation> equations;
  for (const auto& equation : factory.equations) equations.push_back(displayed(equation));
  return equations;
}

std::string value_text(const Parameter& parameter, const ParameterValues& given) {
  const auto value = given.find(parameter.name);
  if (value != given.end()) return to_text(value->second);
  return parameter.default_formula.empty() ? to_text(parameter.value) : parameter.default_formula;
}

std::vector<DescribedParameter> parameters_of(const SceneVariant& variant) {
  std::vector<DescribedParameter> parameters;
  for (const Parameter& parameter : variant.factory->parameters) {
    parameters.push_back({.name = parameter.name,
                          .value = value_text(parameter, variant.values),
                          .meaning = parameter.description,
                          .given = variant.values.contains(parameter.name)});
  }
  return parameters;
}

std::optional<TrialRuns> trial_of(const SceneSettings& scene) {
  const auto all = trials();
  const auto found = std::ranges::find(all, scene, [](const Trial& trial) { return trial.scene.key(); });
  if (found == all.end()) return std::nullopt;
  return TrialRuns{.number = static_cast<int>(found - all.begin()),
                   .kind = found->kind,
                   .steps = found->steps,
                   .accuracy = trial_accuracy};
}

}  // namespace

SceneDescription describe(const SceneVariant& variant, const Scene& scene, MemoizedReference& reference,
                          bool with_solution) {
  const SceneSettings key = variant.key();
  SceneDescription description{.scene = key,
                               .title = variant.factory->title,
                               .source = variant.factory->source,
                               .equations = equations_of(*variant.factory),
                               .parameters = parameters_of(variant),
                               .discontinuities = scene.discontinuities,
                               .evidence = std::string(evidence_of(scene)),
                               .trial = trial_of(key)};
  try {
    const reference::Reference& exact = reference.exact();
    description.reference_seconds = exact.seconds;
    if (with_solution) description.solution = sample_solution(scene, exact);
  } catch (const std::runtime_error&) {  // without a reference there is no solution
  }
  return description;
}

}  // namespace fde::bench
