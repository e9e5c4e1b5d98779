// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// D^g x = v, D^g v = mu (1 - x^2) v - x. For large mu, x varies slowly while |x| > 1, for a time like
// mu^(1/g), and jumps when |x| reaches 1; v approaches -x / (mu (x^2 - 1)) in a layer of length mu^(-1/g).
SceneFactory van_der_pol() {
  return {.id = "van_der_pol",
          .title = "Fractional van der Pol oscillator",
          .source = "Tavazoei, Haeri, Attari, Bolouki & Siami, J. Vib. Control 15 (2009) 803, equal orders",
          .parameters = {{"gamma", 0.9, order_up_to_one, "order"},
                         {"mu", 1.0, {.low = 0.0, .high = 1e6}, "stiffness"},
                         {"x0", 2.0, any_number, "x(0)"},
                         {"v0", 0.0, any_number, "v(0)"}},
          .make = [](const Parameters& p) -> Scene {
            const double gamma = p["gamma"], mu = p["mu"];
            const auto powers = power_lattice({gamma}, {gamma}, gamma + 2.0);
            const auto later = power_lattice({2.0 * gamma}, {gamma}, gamma + 2.0);
            const bool rests = p["v0"] == 0.0;
            return {.problem = {.components = {{gamma, {p["x0"]}}, {gamma, {p["v0"]}}},
                                .rhs =
                                    [=](double, In y, Out f) {
                                      f[0] = y[1];
                                      f[1] = mu * (1.0 - y[0]) * (1.0 + y[0]) * y[1] - y[0];
                                    },
                                .derivatives = DenseJacobian{[=](double, In y, OutMatrix jacobian) {
                                  jacobian << 0.0, 1.0,  //
                                      -2.0 * mu * y[0] * y[1] - 1.0, mu * (1.0 - y[0]) * (1.0 + y[0]);
                                }},
                                .end = 20.0},
                    .smoothness = {{rests ? later : powers, powers}},
                    .outputs = {{"x", "v"}}};
          },
          .equations = {
              {.unknown = "x", .terms = {{"1", "gamma"}}, .rhs = "v", .initial = {"x0"}},
              {.unknown = "v", .terms = {{"1", "gamma"}}, .rhs = "mu*(1 - x^2)*v - x", .initial = {"v0"}}}};
}

}  // namespace fde::bench
