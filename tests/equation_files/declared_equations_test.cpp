// What scenes of the code say of their equations, for readers and other programs: read as a file would be, it
// is the same problem.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "equation_files/equation_scene.hpp"
#include "equation_files/equation_text.hpp"
#include "scenes/number_text.hpp"
#include "scenes/registry.hpp"
#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"
#include "support/testing.hpp"

namespace fde {
namespace {

FormulaText formula(const std::string& text) { return {.text = text}; }

EquationText text_of(const SceneMaker& maker, double end) {
  EquationText text{
      .file = maker.id, .title = maker.title, .end = formula(fde::text_of(ParameterValue(end)))};
  for (const auto& parameter : maker.parameters) {
    if (const auto* value = std::get_if<double>(&parameter.value))
      text.parameters.push_back({parameter.name, *value});
  }
  for (const auto& equation : maker.equations) {
    UnknownText unknown{.name = equation.unknown, .rhs = formula(equation.rhs)};
    for (const auto& [coefficient, order] : equation.terms)
      unknown.terms.push_back({formula(coefficient), formula(order)});
    for (const auto& value : equation.initial) unknown.initial.push_back(formula(value));
    text.unknowns.push_back(unknown);
  }
  return text;
}

// As many initial values as the first component of the unknown has.
void keep_initial_values(EquationText& text, const Parameters& parameters) {
  for (auto& unknown : text.unknowns) {
    const auto& order = unknown.terms.front().order.text;
    const double value = is_decimal(order) ? std::stod(order) : parameters[order];
    unknown.initial.resize(std::min<std::size_t>(unknown.initial.size(), value > 1.0 ? 2 : 1));
  }
}

class DeclaredEquations : public testing::TestWithParam<const SceneMaker*> {};

TEST_P(DeclaredEquations, AreThoseOfTheProblem) {
  const SceneMaker& maker = *GetParam();
  Scene code = make_scene(maker);
  EquationText text = text_of(maker, code.problem.end);
  for (const double jump : code.problem.jumps)
    text.jumps.push_back(formula(fde::text_of(ParameterValue(jump))));
  keep_initial_values(text, Parameters(maker.id, maker.parameters, {}));
  const Scene written = make_scene(equation_scene(text));
  const auto* scheme = find_scheme("spectral_collocation");
  const Accuracy accuracy{1e-10, 1e-10};
  const Options options{.at = {code.problem.end / 4, code.problem.end}};
  const auto a = scheme->solve(written.problem, accuracy, options),
             b = scheme->solve(code.problem, accuracy, options);
  ASSERT_EQ(a.ending, b.ending);
  const auto theirs = columns_of(written.outputs, a), ours = columns_of(code.outputs, b);
  for (const auto& equation : maker.equations) {
    const auto of_code = std::ranges::find(code.outputs.names, equation.unknown);
    if (of_code == code.outputs.names.end()) continue;  // im_y, which is 0 by default
    const auto of_text = std::ranges::find(written.outputs.names, equation.unknown);
    const auto row = ours.row(of_code - code.outputs.names.begin());
    EXPECT_LT((theirs.row(of_text - written.outputs.names.begin()) - row).cwiseAbs().maxCoeff(),
              1e-7 * (1.0 + row.cwiseAbs().maxCoeff()))
        << equation.unknown;
  }
}

std::vector<const SceneMaker*> with_equations() {
  std::vector<const SceneMaker*> makers;
  for (const SceneMaker& maker : scenes()) {
    if (!maker.equations.empty()) makers.push_back(&maker);
  }
  return makers;
}

INSTANTIATE_TEST_SUITE_P(OfEveryScene, DeclaredEquations, testing::ValuesIn(with_equations()),
                         [](const auto& test) { return test.param->id; });

}  // namespace
}  // namespace fde
