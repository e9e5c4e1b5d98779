// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// D^g y1 = -k1 y1 + k3 y2 y3, D^g y2 = k1 y1 - k3 y2 y3 - k2 y2^2, D^g y3 = k2 y2^2. The right-hand sides sum
// to 0, so y1 + y2 + y3 = 1 for every order.
SceneFactory robertson() {
  return {
      .id = "robertson",
      .title = "Fractional Robertson reaction",
      .source = "Robertson, in Numerical Analysis: An Introduction (1966) 178, with D^gamma for d/dt",
      .parameters = {{"gamma", 0.9, order_up_to_one, "order"},
                     {"k1", 0.04, positive, "rate of y1 -> y2"},
                     {"k2", 3e7, positive, "rate of 2 y2 -> y2 + y3"},
                     {"k3", 1e4, positive, "rate of y2 + y3 -> y1 + y3"}},
      .make = [](const Parameters& p) -> Scene {
        const double gamma = p["gamma"], k1 = p["k1"], k2 = p["k2"], k3 = p["k3"];
        const auto powers = power_lattice({gamma}, {gamma}, gamma + 2.0);
        const auto later = power_lattice({3.0 * gamma}, {gamma}, gamma + 2.0);
        return {.problem = {.components = {{gamma, {1.0}}, {gamma, {0.0}}, {gamma, {0.0}}},
                            .rhs =
                                [=](double, In y, Out f) {
                                  const double first = k1 * y[0] - k3 * y[1] * y[2];
                                  const double second = k2 * y[1] * y[1];
                                  f << -first, first - second, second;
                                },
                            .derivatives = DenseJacobian{[=](double, In y, OutMatrix jacobian) {
                              const double by_y2 = 2.0 * k2 * y[1];
                              jacobian << -k1, k3 * y[2], k3 * y[1],   //
                                  k1, -k3 * y[2] - by_y2, -k3 * y[1],  //
                                  0.0, by_y2, 0.0;
                            }},
                            .end = 40.0},
                .smoothness = {{powers, powers, later}},
                .outputs = {{"y1", "y2", "y3"}},
                .constraint = {.size = 1, .value = [](double, In c, Out f) { f[0] = c.sum() - 1.0; }}};
      },
      .equations = {
          {.unknown = "y1", .terms = {{"1", "gamma"}}, .rhs = "-k1*y1 + k3*y2*y3", .initial = {"1"}},
          {.unknown = "y2", .terms = {{"1", "gamma"}}, .rhs = "k1*y1 - k3*y2*y3 - k2*y2^2", .initial = {"0"}},
          {.unknown = "y3", .terms = {{"1", "gamma"}}, .rhs = "k2*y2^2", .initial = {"0"}}}};
}

}  // namespace fde::bench
