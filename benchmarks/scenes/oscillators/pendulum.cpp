#include <cmath>

#include "closed_forms/free_pendulum.hpp"
#include "problem/chain.hpp"
#include "scenes/oscillators/damping.hpp"
#include "scenes/scene.hpp"

namespace fde {

// phi'' + g/L sin phi + mu tau^alpha D^alpha phi + lambda tau phi' + nu tau^beta D^beta phi = 0, energy per m
// L^2. Without damping in closed form, by Jacobi's elliptic functions.
SceneMaker pendulum() {
  auto parameters = damping_parameters();
  parameters.insert(parameters.end(), {{"mu", 0.06, not_negative, "damping of order alpha"},
                                       {"lambda", 0.1, not_negative, "damping of order 1"},
                                       {"nu", 0.1, not_negative, "damping of order beta"},
                                       {"g_over_L", 1.0, any_number, "gravity over length"},
                                       {"phi0", 1.0, any_number, "phi(0)"},
                                       {"dphi0", -0.3, any_number, "phi'(0)"}});
  return {.id = "pendulum",
          .title = "Pendulum with fractional damping",
          .source = "Yin, Liu & Anh 2007, eqs 5.1-5.5, example 1; energy eq. 5.3",
          .parameters = parameters,
          .make = [](const Parameters& p) -> Scene {
            const double g = p["g_over_L"];
            const auto terms = damping_terms(p, p["mu"], p["lambda"], p["nu"]);
            const Chain chain({1.0, 2.0}, terms, {p["phi0"], p["dphi0"]});
            const DampedColumns columns(terms, "phi");
            const bool free = columns.names.size() == 2 && p["lambda"] == 0.0;
            return {
                .problem = {.components = chain.components(),
                            .rhs = [=](double, In y,
                                       Out f) { Chain::links(y, chain.highest(y, -g * std::sin(y[0])), f); },
                            .jacobian =
                                [=](double, In y, OutMatrix jacobian) {
                                  jacobian = chain.linear_part(-g * std::cos(y[0]));
                                },
                            .end = 20.0},
                .smoothness = chain_smoothness({chain}),
                .outputs = picked(columns.names, columns.components(chain)),
                .reference = free ? pendulum_reference(FreePendulum{g, p["phi0"], p["dphi0"]}) : Reference{},
                .energy = {.value =
                               [=](In c) {
                                 const double dphi = columns.du(c);
                                 return 0.5 * dphi * dphi + g * (1.0 - std::cos(columns.u(c)));
                               },
                           .power = [=](double, In c) { return columns.power(c); }}};
          }};
}

}  // namespace fde
