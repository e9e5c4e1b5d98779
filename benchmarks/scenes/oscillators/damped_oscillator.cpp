#include "linear/linear_equation.hpp"
#include "problem/chain.hpp"
#include "scenes/oscillators/damping.hpp"
#include "scenes/scene.hpp"

namespace fde {

// u'' + mu tau^alpha D^alpha u + lambda tau u' + nu tau^beta D^beta u + w2 u = 0: the pendulum with sin u ->
// u.
SceneMaker damped_oscillator() {
  auto parameters = damping_parameters();
  parameters.insert(parameters.end(), {{"mu", 0.06, not_negative, "damping of order alpha"},
                                       {"lambda", 0.1, not_negative, "damping of order 1"},
                                       {"nu", 0.1, not_negative, "damping of order beta"},
                                       {"w2", 1.0, any_number, "square of the frequency"},
                                       {"u0", 1.0, any_number, "u(0)"},
                                       {"du0", -0.3, any_number, "u'(0)"}});
  return {
      .id = "damped_oscillator",
      .title = "Oscillator with fractional damping",
      .source = "Yin, Liu & Anh 2007, eq. 5.1 linearised",
      .parameters = parameters,
      .make = [](const Parameters& p) -> Scene {
        const double w2 = p["w2"];
        const auto terms = damping_terms(p, p["mu"], p["lambda"], p["nu"]);
        const Chain chain({1.0, 2.0}, terms, {p["u0"], p["du0"]});
        const DampedColumns columns(terms, "u");
        LinearEquation equation{.terms = {{1.0, 2.0}, {w2, 0.0}}, .initial = {p["u0"], p["du0"]}};
        for (const auto& [name, order] : {std::pair{"nu", p["beta"]}, {"lambda", 1.0}, {"mu", p["alpha"]}}) {
          equation.terms.push_back({p[name], order, p["tau"]});
        }
        return {
            .problem = {.components = chain.components(),
                        .rhs = [=](double, In y, Out f) { Chain::links(y, chain.highest(y, -w2 * y[0]), f); },
                        .linear_part = chain.linear_part(-w2),
                        .end = 20.0},
            .smoothness = chain_smoothness({chain}),
            .outputs = picked(columns.names, columns.components(chain)),
            .reference = linear_reference(equation, columns.orders),
            .energy = {.value =
                           [=](In c) {
                             const double u = columns.u(c), du = columns.du(c);
                             return 0.5 * (du * du + w2 * u * u);
                           },
                       .power = [=](double, In c) { return columns.power(c); }}};
      }};
}

}  // namespace fde
