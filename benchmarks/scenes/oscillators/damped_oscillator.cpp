// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/oscillators/damping.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/schemes/problem/chain_problem.hpp"

namespace fde::bench {
namespace {

reference::LinearEquation equation(const Parameters& p) {
  return {.terms = {{1.0, 2.0},
                    {p["w2"], 0.0},
                    {p["nu"], p["beta"], p["tau"]},
                    {p["lambda"], 1.0, p["tau"]},
                    {p["mu"], p["alpha"], p["tau"]}},
          .initial = {p["u0"], p["du0"]}};
}

}  // namespace

// u'' + mu tau^alpha D^alpha u + lambda tau u' + nu tau^beta D^beta u = -w2 u: the pendulum with sin u -> u.
SceneFactory damped_oscillator() {
  return {.id = "damped_oscillator",
          .title = "Oscillator with fractional damping",
          .source = "Yin, Liu & Anh 2007, eq. 5.1 linearised",
          .parameters = damping_parameters({{"mu", 0.06, not_negative, "damping of order alpha"},
                                            {"lambda", 0.1, not_negative, "damping of order 1"},
                                            {"nu", 0.1, not_negative, "damping of order beta"},
                                            {"w2", 1.0, any_number, "square of the frequency"},
                                            {"u0", 1.0, any_number, "u(0)"},
                                            {"du0", -0.3, any_number, "u'(0)"}}),
          .make = [](const Parameters& p) -> Scene {
            const double w2 = p["w2"];
            const DampedUnknown u("u", p, {p["mu"], p["lambda"], p["nu"]}, {p["u0"], p["du0"]});
            const Problem problem = chain_problem({{.chain = u.chain(),
                                                    .force = [=](double, In y) { return -w2 * y[0]; },
                                                    .derivatives = LinearForce{-w2}}},
                                                  20.0);
            return {
                .problem = problem,
                .smoothness = smoothness_of_chains({u.chain()}),
                .outputs = outputs_of({u}, problem),
                .reference = reference::linear_reference(equation(p), u.orders()),
                .energy = {.value = [=](In c) { return 0.5 * (u.du(c) * u.du(c) + w2 * u.u(c) * u.u(c)); },
                           .power = [=](double, In c) { return u.power(c); }},
                .discontinuities = u.discontinuities()};
          },
          .equations = {
              {.unknown = "u",
               .terms = {{"1", "2"}, {"mu*tau^alpha", "alpha"}, {"lambda*tau", "1"}, {"nu*tau^beta", "beta"}},
               .rhs = "-w2*u",
               .initial = {"u0", "du0"}}}};
}

}  // namespace fde::bench
