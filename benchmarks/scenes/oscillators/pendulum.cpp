// SPDX-License-Identifier: MIT
#include <cmath>

#include "fdebench/benchmarks/scenes/oscillators/damping.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/closed_forms/free_pendulum.hpp"
#include "fdebench/schemes/problem/chain_problem.hpp"

namespace fde::bench {

// phi'' + mu tau^alpha D^alpha phi + lambda tau phi' + nu tau^beta D^beta phi = -g/L sin phi, energy per m
// L^2. Without damping the reference is a closed form with Jacobi elliptic functions.
SceneFactory pendulum() {
  return {.id = "pendulum",
          .title = "Pendulum with fractional damping",
          .source = "Yin, Liu & Anh 2007, eqs 5.1-5.5, example 1; energy eq. 5.3",
          .parameters = damping_parameters({{"mu", 0.06, not_negative, "damping of order alpha"},
                                            {"lambda", 0.1, not_negative, "damping of order 1"},
                                            {"nu", 0.1, not_negative, "damping of order beta"},
                                            {"g_over_L", 1.0, any_number, "gravity over length"},
                                            {"phi0", 1.0, any_number, "phi(0)"},
                                            {"dphi0", -0.3, any_number, "phi'(0)"}}),
          .make = [](const Parameters& p) -> Scene {
            const double g = p["g_over_L"];
            const DampedUnknown phi("phi", p, {p["mu"], p["lambda"], p["nu"]}, {p["phi0"], p["dphi0"]});
            const bool free = phi.chain().terms().empty() && phi.inertia() == 0.0;
            const Problem problem = chain_problem(
                {{.chain = phi.chain(),
                  .force = [=](double, In y) { return -g * std::sin(y[0]); },
                  .derivatives =
                      ForceGradient{[=](double, In y, double, Out by) { by[0] -= g * std::cos(y[0]); }}}},
                20.0);
            return {.problem = problem,
                    .smoothness = smoothness_of_chains({phi.chain()}),
                    .outputs = outputs_of({phi}, problem),
                    .reference = free ? pendulum_reference(reference::FreePendulum{g, p["phi0"], p["dphi0"]})
                                      : reference::Reference{},
                    .energy = {.value =
                                   [=](In c) {
                                     const double dphi = phi.du(c);
                                     return 0.5 * dphi * dphi + g * (1.0 - std::cos(phi.u(c)));
                                   },
                               .power = [=](double, In c) { return phi.power(c); }},
                    .discontinuities = phi.discontinuities()};
          },
          .equations = {
              {.unknown = "phi",
               .terms = {{"1", "2"}, {"mu*tau^alpha", "alpha"}, {"lambda*tau", "1"}, {"nu*tau^beta", "beta"}},
               .rhs = "-g_over_L*sin(phi)",
               .initial = {"phi0", "dphi0"}}}};
}

}  // namespace fde::bench
