// SPDX-License-Identifier: MIT
// The equations that scenes in C++ declare as text, parsed like a file, give the same problem as the code.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

FormulaText formula(const std::string& text) { return {.text = text}; }

bool is_unknown(const SceneFactory& factory, const std::string& name) {
  return std::ranges::find(factory.equations, name, &EquationFormula::unknown) != factory.equations.end();
}

// A parameter may have the name of the unknown whose initial value it is.
std::string of_parameters(const SceneFactory& factory, const std::string& formula) {
  return is_unknown(factory, formula) ? formula + "_0" : formula;
}

// Replaces a derived parameter by its formula, also an initial value that has the name of its unknown.
std::string without_derived(const SceneFactory& factory, std::string formula) {
  for (const auto& parameter : factory.parameters) {
    if (!parameter.default_formula.empty()) {
      formula = std::regex_replace(formula, std::regex("\\b" + parameter.name + "\\b"),
                                   "(" + parameter.default_formula + ")");
    }
  }
  return formula;
}

// In a file only derivatives that are nodes of a chain are available: a D(x,q) that occurs on the right only
// is added on both sides.
void add_nodes(EquationText& text) {
  static const std::regex derivative(R"(D\((\w+),(\w+)\))");
  std::set<std::pair<std::string, std::string>> asked;
  for (const auto& unknown : text.unknowns) {
    const std::string& rhs = unknown.rhs.text;
    for (auto at = std::sregex_iterator(rhs.begin(), rhs.end(), derivative); at != std::sregex_iterator();
         ++at) {
      if ((*at)[2] != "1") asked.emplace((*at)[1], (*at)[2]);
    }
  }
  for (const auto& derivative_of : asked) {
    const auto &name = derivative_of.first, &order = derivative_of.second;
    auto& unknown = *std::ranges::find(text.unknowns, name, &UnknownText::name);
    const auto has = [&](const auto& term) { return term.order.text == order; };
    if (std::ranges::any_of(unknown.terms, has)) continue;
    unknown.terms.push_back({formula("1"), formula(order)});
    unknown.rhs.text.append(" + D(").append(name).append(",").append(order).append(")");
  }
}

bool has_algebraic_rows(const SceneFactory& factory) {
  return std::ranges::any_of(
      factory.equations, [](const EquationFormula& equation) { return equation.terms.front().order == "0"; });
}

EquationText equation_text_of(const SceneFactory& factory, double end) {
  EquationText text{.file = factory.id, .title = factory.title, .end = formula(to_text(ParameterValue(end)))};
  for (const auto& parameter : factory.parameters) {
    if (const auto* value = std::get_if<double>(&parameter.value)) {
      text.parameters.push_back(
          {.declared = {of_parameters(factory, parameter.name), *value, any_number, parameter.description}});
    }
  }
  for (const auto& equation : factory.equations) {
    UnknownText unknown{.name = equation.unknown,
                        .may_be_algebraic = equation.terms.front().order == "0",
                        .rhs = formula(without_derived(factory, equation.rhs))};
    for (const auto& [coefficient, order] : equation.terms)
      unknown.terms.push_back({formula(coefficient), formula(order)});
    for (const auto& value : equation.initial)
      unknown.initial.push_back(formula(of_parameters(factory, value)));
    text.unknowns.push_back(unknown);
  }
  add_nodes(text);
  return text;
}

// Keeps as many initial values as the first component of the unknown has.
void keep_initial_values(EquationText& text, const Parameters& parameters) {
  for (auto& unknown : text.unknowns) {
    const auto& order = unknown.terms.front().order.text;
    if (!is_decimal(order) && order.find_first_of(" -") != std::string::npos) continue;
    const double value = is_decimal(order) ? std::stod(order) : parameters[order];
    unknown.initial.resize(std::min<std::size_t>(unknown.initial.size(), value > 1.0 ? 2 : 1));
  }
}

class DeclaredEquations : public testing::TestWithParam<const SceneFactory*> {};

TEST_P(DeclaredEquations, AreThoseOfTheProblem) {
  const SceneFactory& factory = *GetParam();
  Scene code = make_scene(factory);
  EquationText text = equation_text_of(factory, code.problem.end);
  for (const double jump : code.problem.jump_times)
    text.jumps.push_back(formula(to_text(ParameterValue(jump))));
  keep_initial_values(text, Parameters(factory.id, factory.parameters, {}));
  const Scene written = make_scene(equation_scene(text));
  const bool constrained = has_algebraic_rows(factory);
  const auto* scheme = find_scheme(constrained ? "radau_exponentials" : "spectral_collocation");
  const double error = constrained ? 1e-8 : 1e-10;
  const Tolerance accuracy{error, error};
  const Options options{.output_times = {code.problem.end / 4, code.problem.end}};
  const auto a = scheme->solve(written.problem, accuracy, options),
             b = solve("spectral_collocation", code.problem, Tolerance{1e-10, 1e-10}, options);
  ASSERT_EQ(a.status, b.status);
  const auto theirs = columns_of(written.outputs, a), ours = columns_of(code.outputs, b);
  for (const auto& equation : factory.equations) {
    const auto of_code = std::ranges::find(code.outputs.names, equation.unknown);
    if (of_code == code.outputs.names.end()) continue;
    const auto of_text = std::ranges::find(written.outputs.names, equation.unknown);
    const auto row = ours.row(of_code - code.outputs.names.begin());
    EXPECT_LT((theirs.row(of_text - written.outputs.names.begin()) - row).cwiseAbs().maxCoeff(),
              (constrained ? 1e-5 : 1e-7) * (1.0 + row.cwiseAbs().maxCoeff()))
        << equation.unknown;
  }
}

std::vector<const SceneFactory*> with_equations() {
  std::vector<const SceneFactory*> makers;
  for (const SceneFactory& factory : built_in_scenes()) {
    if (!factory.equations.empty() && factory.toml.empty()) makers.push_back(&factory);
  }
  return makers;
}

INSTANTIATE_TEST_SUITE_P(OfEveryScene, DeclaredEquations, testing::ValuesIn(with_equations()), id_of_param);

}  // namespace
}  // namespace fde::bench
