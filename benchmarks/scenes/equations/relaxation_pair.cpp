// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/initial_values.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/linear_system.hpp"
#include "fdebench/schemes/problem/linear_smoothness.hpp"

namespace fde::bench {

// D^g u = lambda u for u = x + i y and lambda = re + i im, as a real 2x2 system:
// u = u(0) E_g(lambda t^g) + u'(0) t E_{g,2}(lambda t^g). Stable for |arg lambda| > g pi / 2.
SceneFactory relaxation_pair() {
  return {.id = "relaxation_pair",
          .title = "Relaxation with a complex rate",
          .source = "Matignon, CESA'96 (1996), stability sector",
          .parameters = {{"gamma", 0.8, order_up_to_two, "order"},
                         {"re", -1.0, any_number, "real part of the rate"},
                         {"im", 2.0, any_number, "imaginary part of the rate"},
                         {"x0", 1.0, any_number, "x(0)"},
                         {"y0", 0.0, any_number, "y(0)"},
                         {"dx0", 0.0, any_number, "x'(0), for gamma > 1"},
                         {"dy0", 0.0, any_number, "y'(0), for gamma > 1"}},
          .make = [](const Parameters& p) -> Scene {
            const double gamma = p["gamma"];
            const std::vector<Component> components{{gamma, initial_values(p, "gamma", "x0", "dx0")},
                                                    {gamma, initial_values(p, "gamma", "y0", "dy0")}};
            const Matrix rotation = (Matrix(2, 2) << p["re"], -p["im"], p["im"], p["re"]).finished();
            return {.problem = {.components = components,
                                .rhs = [=](double, In y, Out f) { f = rotation * y; },
                                .derivatives = DenseLinearPart{rotation},
                                .end = 5.0},
                    .smoothness = linear_smoothness(components, rotation),
                    .outputs = {{"x", "y"}},
                    .reference = reference::linear_reference(
                        {.orders = {gamma, gamma},
                         .initial = {components[0].initial, components[1].initial},
                         .matrix = rotation})};
          },
          .equations = {
              {.unknown = "x", .terms = {{"1", "gamma"}}, .rhs = "re*x - im*y", .initial = {"x0", "dx0"}},
              {.unknown = "y", .terms = {{"1", "gamma"}}, .rhs = "im*x + re*y", .initial = {"y0", "dy0"}}}};
}

}  // namespace fde::bench
