#include "linear/linear_system.hpp"
#include "scenes/scene.hpp"

namespace fde {

// D^g u = (re + i im) u for u = x + i y, as a real 2x2 system. Stable for |arg lambda| > g pi / 2.
SceneMaker relaxation_pair() {
  return {.id = "relaxation_pair",
          .title = "Relaxation with a complex rate",
          .source = "Matignon, CESA'96 (1996), stability sector",
          .parameters = {{"gamma", 0.8, order_up_to_one, "order"},
                         {"re", -1.0, any_number, "real part of the rate"},
                         {"im", 2.0, any_number, "imaginary part of the rate"},
                         {"x0", 1.0, any_number, "x(0)"},
                         {"y0", 0.0, any_number, "y(0)"}},
          .make = [](const Parameters& p) -> Scene {
            const double gamma = p["gamma"];
            const auto powers = power_lattice({gamma}, {gamma}, gamma + 2.0);
            const Matrix rotation = (Matrix(2, 2) << p["re"], -p["im"], p["im"], p["re"]).finished();
            return {.problem = {.components = {{gamma, {p["x0"]}}, {gamma, {p["y0"]}}},
                                .rhs = [=](double, In y, Out f) { f = rotation * y; },
                                .derivatives = DenseLinearPart{rotation},
                                .end = 5.0},
                    .smoothness = {{powers, powers}},
                    .outputs = {{"x", "y"}},
                    .reference = linear_reference(
                        {.orders = {gamma, gamma}, .initial = {{p["x0"]}, {p["y0"]}}, .matrix = rotation})};
          }};
}

}  // namespace fde
