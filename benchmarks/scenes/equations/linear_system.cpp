// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/linear_system.hpp"

#include "fdebench/benchmarks/scenes/equations/initial_values.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/problem/linear_smoothness.hpp"

namespace fde::bench {
// D^g1 x = a11 x + a12 y + c1, D^g2 y = a21 x + a22 y + c2, each with its own order. The coefficients can be
// chosen for complex, defective or very stiff spectra.
SceneFactory linear_system() {
  return {
      .id = "linear_system",
      .title = "Linear system of two orders",
      .source = "Diethelm, The Analysis of Fractional Differential Equations (2010), chapter 8",
      .parameters = {{"gamma1", 0.6, order_up_to_two, "order of x"},
                     {"gamma2", 1.5, order_up_to_two, "order of y"},
                     {"a11", -1.0, any_number, "x in D^gamma1 x"},
                     {"a12", 1.0, any_number, "y in D^gamma1 x"},
                     {"a21", -1.0, any_number, "x in D^gamma2 y"},
                     {"a22", -4.0, any_number, "y in D^gamma2 y"},
                     {"x0", 1.0, any_number, "x(0)"},
                     {"y0", 0.5, any_number, "y(0)"},
                     {"dx0", 0.0, any_number, "x'(0), for gamma1 > 1"},
                     {"dy0", 0.0, any_number, "y'(0), for gamma2 > 1"},
                     {"c1", 0.0, any_number, "constant load of x"},
                     {"c2", 0.0, any_number, "constant load of y"}},
      .make = [](const Parameters& p) -> Scene {
        const Matrix matrix = (Matrix(2, 2) << p["a11"], p["a12"], p["a21"], p["a22"]).finished();
        const Vec load = (Vec(2) << p["c1"], p["c2"]).finished();
        const std::vector<Component> components{{p["gamma1"], initial_values(p, "gamma1", "x0", "dx0")},
                                                {p["gamma2"], initial_values(p, "gamma2", "y0", "dy0")}};
        return {.problem = {.components = components,
                            .rhs = [=](double, In y, Out f) { f = matrix * y + load; },
                            .derivatives = DenseLinearPart{matrix},
                            .end = 5.0},
                .smoothness = linear_smoothness(components, matrix, {{0.0, load}}),
                .outputs = {{"x", "y"}},
                .reference =
                    reference::linear_reference({.orders = {components[0].order, components[1].order},
                                                 .initial = {components[0].initial, components[1].initial},
                                                 .matrix = matrix,
                                                 .loads = {{{load[0]}}, {{load[1]}}}})};
      },
      .equations = {
          {.unknown = "x", .terms = {{"1", "gamma1"}}, .rhs = "a11*x + a12*y + c1", .initial = {"x0", "dx0"}},
          {.unknown = "y",
           .terms = {{"1", "gamma2"}},
           .rhs = "a21*x + a22*y + c2",
           .initial = {"y0", "dy0"}}}};
}

}  // namespace fde::bench
