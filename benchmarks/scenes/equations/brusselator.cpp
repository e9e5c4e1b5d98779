// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// D^g x = A - (B+1) x + x^2 y, D^g y = B x - x^2 y.
SceneFactory brusselator() {
  return {.id = "brusselator",
          .title = "Fractional Brusselator",
          .source = "Garrappa, Mathematics 6 (2018) 16, section 6, test problem",
          .parameters = {{"gamma", 0.8, order_up_to_one, "order"},
                         {"A", 1.0, any_number, "feed"},
                         {"B", 4.0, any_number, "conversion"},
                         {"x0", 1.2, any_number, "x(0)"},
                         {"y0", 2.8, any_number, "y(0)"}},
          .make = [](const Parameters& p) -> Scene {
            const double gamma = p["gamma"], a = p["A"], b = p["B"];
            const auto powers = power_lattice({gamma}, {gamma}, gamma + 2.0);
            return {.problem = {.components = {{gamma, {p["x0"]}}, {gamma, {p["y0"]}}},
                                .rhs =
                                    [=](double, In y, Out f) {
                                      const double made = y[0] * y[0] * y[1];
                                      f[0] = a - (b + 1.0) * y[0] + made;
                                      f[1] = b * y[0] - made;
                                    },
                                .derivatives = DenseJacobian{[=](double, In y, OutMatrix jacobian) {
                                  const double by_x = 2.0 * y[0] * y[1], by_y = y[0] * y[0];
                                  jacobian << by_x - b - 1.0, by_y, b - by_x, -by_y;
                                }},
                                .end = 50.0},
                    .smoothness = {{powers, powers}},
                    .outputs = {{"x", "y"}}};
          },
          .equations = {
              {.unknown = "x", .terms = {{"1", "gamma"}}, .rhs = "A - (B + 1)*x + x^2*y", .initial = {"x0"}},
              {.unknown = "y", .terms = {{"1", "gamma"}}, .rhs = "B*x - x^2*y", .initial = {"y0"}}}};
}

}  // namespace fde::bench
