// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/initial_values.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/linear_equation.hpp"

namespace fde::bench {

// D^g y = lambda y: y = y0 E_g(lambda t^g) + y'(0) t E_{g,2}(lambda t^g). Starts like t^g, so uniform grids
// lose rate.
SceneFactory relaxation() {
  return {.id = "relaxation",
          .title = "Fractional relaxation",
          .source = "Podlubny, Fractional Differential Equations (1999), section 4.1",
          .parameters = {{"gamma", 0.5, order_up_to_two, "order"},
                         {"lambda", -1.0, any_number, "rate"},
                         {"y0", 1.0, any_number, "y(0)"},
                         {"dy0", 0.0, any_number, "y'(0), for gamma > 1"}},
          .make = [](const Parameters& p) -> Scene {
            const double gamma = p["gamma"], lambda = p["lambda"];
            const auto initial = initial_values(p, "gamma", "y0", "dy0");
            std::vector<double> start;
            if (lambda * p["y0"] != 0.0) start.push_back(gamma);
            if (lambda * p["dy0"] != 0.0) start.push_back(gamma + 1.0);
            return {.problem = {.components = {{gamma, initial}},
                                .rhs = [=](double, In y, Out f) { f = lambda * y; },
                                .derivatives = DenseLinearPart{Matrix::Constant(1, 1, lambda)}},
                    .smoothness = {{power_lattice(start, {gamma}, gamma + 2.0)}},
                    .outputs = {{"y"}},
                    .reference = reference::linear_reference({.terms = {{1.0, gamma}, {-lambda, 0.0}},
                                                              .initial = {initial.begin(), initial.end()}},
                                                             {0.0})};
          },
          .equations = {
              {.unknown = "y", .terms = {{"1", "gamma"}}, .rhs = "lambda*y", .initial = {"y0", "dy0"}}}};
}

}  // namespace fde::bench
