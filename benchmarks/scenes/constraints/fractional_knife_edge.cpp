// SPDX-License-Identifier: MIT
#include <algorithm>

#include "fdebench/benchmarks/scenes/with_reference.hpp"

namespace fde::bench {

SceneFactory fractional_knife_edge_plane();   // of fractional_knife_edge_plane.toml
SceneFactory fractional_knife_edge_sphere();  // of fractional_knife_edge_sphere.toml

// The constraint a(q).v + b a(q).D^alpha q = 0 on a plane and on a sphere. For alpha = 1 it is 1 + b times
// the constraint without memory: the scenes knife_edge and, with g = 0, loxodrome.
SceneFactory fractional_knife_edge() {
  const auto plane = fractional_knife_edge_plane(), sphere = fractional_knife_edge_sphere();
  SceneFactory both{.id = "fractional_knife_edge",
                    .title = "Knife edge with memory on an inclined plane or a sphere",
                    .source = sphere.source,
                    .parameters = {choice("surface", {"plane", "sphere"}, "what the blade is on")},
                    .make = {}};
  both.make = [plane, sphere](const Parameters& p) -> Scene {
    if (p["alpha"] == 1.0 && p["b"] == -1.0) reject("b", -1.0, "other than -1 for alpha = 1");
    const auto& chosen = p.choice("surface") == "plane" ? plane : sphere;
    return chosen.make(parameters_of(chosen, p));
  };
  for (const auto& parameter : plane.parameters)
    if (parameter.name != "formulation" && parameter.name != "kappa") both.parameters.push_back(parameter);
  for (const auto& parameter : sphere.parameters) {
    const auto has_name = [&](const Parameter& one) { return one.name == parameter.name; };
    if (std::ranges::none_of(both.parameters, has_name)) both.parameters.push_back(parameter);
  }
  both.display_equations = {{"d_over_dt*dL_over_dv - dL_over_dq", "lambda*a(q)"},
                            {"a(q)*(D(q, 1) + b*D(q, alpha))", "0"}};
  return both;
}

}  // namespace fde::bench
