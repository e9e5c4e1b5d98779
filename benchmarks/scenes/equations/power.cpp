// SPDX-License-Identifier: MIT
#include <cmath>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/closed_forms/power_sum.hpp"
#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/reference/special_functions/numbers/log_gamma.hpp"

namespace fde::bench {
// Manufactured solution y = t^p of D^g y = Gamma(p+1)/Gamma(p+1-g) t^(p-g) + t^p - y: p sets the smoothness.
SceneFactory power() {
  return {
      .id = "power",
      .title = "A power of time",
      .source = "manufactured from y = t^p",
      .parameters = {{"gamma", 0.5, order_up_to_two, "order"},
                     {"p", 2.0, {.low = 0.0, .high = 50.0, .open_low = true}, "power, at least gamma"}},
      .make = [](const Parameters& parameters) -> Scene {
        const double gamma = parameters["gamma"], p = parameters["p"];
        if (p < gamma) reject("p", p, "at least gamma: the right-hand side is infinite at 0 otherwise");
        const double factor = std::exp(reference::log_gamma(p + 1.0) - reference::log_gamma(p + 1.0 - gamma));
        return {.problem = {.components = {{gamma, std::vector<double>(gamma > 1.0 ? 2 : 1, 0.0)}},
                            .rhs =
                                [=](double t, In y, Out f) {
                                  f = (factor * std::pow(t, p - gamma) + std::pow(t, p) - y.array()).matrix();
                                },
                            .derivatives = DenseLinearPart{Matrix::Constant(1, 1, -1.0)}},
                .smoothness = {{{p}}},
                .outputs = {{"y"}},
                .reference = reference::power_sum({{1.0, p}})};
      },
      .equations = {{.unknown = "y",
                     .terms = {{"1", "gamma"}},
                     .rhs = "gamma(p + 1)/gamma(p + 1 - gamma)*t^(p - gamma) + t^p - y",
                     .initial = {"0", "0"}}}};
}

}  // namespace fde::bench
