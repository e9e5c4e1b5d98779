// SPDX-License-Identifier: MIT
#include <cmath>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/closed_forms/power_sum.hpp"
#include "fdebench/reference/linear/linear_equation.hpp"

namespace fde::bench {

// Nonlinear, with D^g y twice differentiable although y starts like t^g: y = t^8 - 3 t^(4+g/2) + 9/4 t^g. The
// absolute values extend the published problem, 0 <= t <= 1, beyond the zero of 3/2 t^(g/2) - t^4.
SceneFactory diethelm() {
  return {.id = "diethelm",
          .title = "Nonlinear test of Diethelm, Ford & Freed",
          .source = "Diethelm, Ford & Freed, Numerical Algorithms 36 (2004), section 5",
          .parameters = {{"gamma", 0.5, order_up_to_two, "order"}},
          .make = [](const Parameters& p) -> Scene {
            const double g = p["gamma"];
            const double of_eighth = 40320.0 / std::tgamma(9.0 - g);
            const double of_fourth = 3.0 * std::tgamma(5.0 + g / 2) / std::tgamma(5.0 - g / 2);
            const double constant = 2.25 * std::tgamma(g + 1.0);
            return {.problem = {.components = {{g, std::vector<double>(g > 1.0 ? 2 : 1, 0.0)}},
                                .rhs =
                                    [=](double t, In y, Out f) {
                                      const double root = std::abs(1.5 * std::pow(t, g / 2) - std::pow(t, 4));
                                      f[0] = of_eighth * std::pow(t, 8.0 - g) -
                                             of_fourth * std::pow(t, 4.0 - g / 2) + constant +
                                             root * root * root - std::pow(std::abs(y[0]), 1.5);
                                    },
                                .derivatives = DenseJacobian{[](double, In y, OutMatrix jacobian) {
                                  jacobian(0, 0) = -1.5 * std::copysign(std::sqrt(std::abs(y[0])), y[0]);
                                }}},
                    .smoothness = {{{g, 4.0 + g / 2, 8.0}}},
                    .outputs = {{"y"}},
                    .reference = reference::power_sum({{1.0, 8.0}, {-3.0, 4.0, 0.5}, {2.25, 0.0, 1.0}}, g)};
          },
          .equations = {
              {.unknown = "y",
               .terms = {{"1", "gamma"}},
               .rhs = "40320/gamma(9 - gamma)*t^(8 - gamma) - 3*gamma(5 + gamma/2)/gamma(5 - gamma/2)*t^(4 "
                      "- gamma/2) + 9/4*gamma(gamma + 1) + abs(3/2*t^(gamma/2) - t^4)^3 - abs(y)^1.5",
               .initial = {"0", "0"}}}};
}

}  // namespace fde::bench
