// SPDX-License-Identifier: MIT
#include <utility>

#include "fdebench/benchmarks/scenes/with_reference.hpp"

namespace fde::bench {

SceneFactory nonlinear_fractional_oscillator_file();  // of nonlinear_fractional_oscillator.toml
SceneFactory nonlinear_fractional_oscillator_pair();  // of nonlinear_fractional_oscillator_pair.toml

namespace {

// The full system with the columns x and x', the means of those of the two points, and equation (66) for the
// reference.
Scene pair_of_points(const SceneFactory& pair, const Parameters& p, const Scene& reduced) {
  ParameterValues values{{"formulation", p.choice("form")}};
  for (const auto& parameter : pair.parameters) {
    if (parameter.choices.empty() && parameter.name != "kappa")
      values[parameter.name] = p.value(parameter.name);
  }
  Scene full = pair.make(Parameters(pair.id, pair.parameters, values));
  const auto middle = [points = full.outputs](double t, In state, Out seen) {
    const Vec of_points = columns_at(points, t, state);
    seen << 0.5 * (of_points[0] + of_points[1]), 0.5 * (of_points[2] + of_points[3]);
  };
  Scene scene{.problem = std::move(full.problem),
              .ill_posed_reason = std::move(full.ill_posed_reason),
              .smoothness = std::move(full.smoothness),
              .outputs = {reduced.outputs.names, middle},
              .reference_problem = PosedProblem{reduced.problem, reduced.outputs}};
  // The rows of w and of the multiplier, which are the last ones, are not measured.
  const Eigen::Index first = p.choice("form") == "integrated" ? 5 : 4;
  for (Eigen::Index i = first; i < scene.problem.size(); ++i) scene.smoothness.unmeasured.push_back(i);
  return scene;
}

}  // namespace

SceneFactory nonlinear_fractional_oscillator() {
  SceneFactory file = nonlinear_fractional_oscillator_file();
  Parameter form =
      choice("form", {"reduced", "integrated", "multiplier"}, "equation 66, or forms of 59 and 60");
  form.keeps_solution = true;
  file.parameters.insert(file.parameters.begin(), std::move(form));
  file.make = [make = file.make,
               pair = nonlinear_fractional_oscillator_pair()](const Parameters& p) -> Scene {
    Scene reduced = make(p);
    return p.choice("form") == "reduced" ? reduced : pair_of_points(pair, p, reduced);
  };
  return file;
}

}  // namespace fde::bench
