#include "linear/linear_equation.hpp"
#include "scenes/scene.hpp"

namespace fde {

// D^nu q + w2 q = c0 + c1 t, 1 < nu <= 2. The load of Tarasov & Zaslavsky's (49), nu = alpha - 1, is
// q''(0) t^(3-alpha)/Gamma(4-alpha) + w2 (q(0) + q'(0) t): the printed one has q(0) where q''(0) belongs.
// fractional_constraint_1d has that load. Without one q is q(0) E_nu(-w2 t^nu) + q'(0) t E_{nu,2}(-w2 t^nu),
// (51) to (53) with nu for alpha; the convolution with the load in (50) and (54) lacks a factor 1/w2 there.
SceneMaker fractional_oscillator() {
  return {.id = "fractional_oscillator",
          .title = "Fractional oscillator",
          .source = "Tarasov & Zaslavsky 2006, eqs 49-54 (corrected)",
          .parameters = {{"nu", 1.5, {.low = 1.0, .high = 2.0, .open_low = true}, "order"},
                         {"w2", 1.0, any_number, "square of the frequency"},
                         {"q0", 1.0, any_number, "q(0)"},
                         {"dq0", 0.0, any_number, "q'(0)"},
                         {"c0", 0.0, any_number, "constant load"},
                         {"c1", 0.0, any_number, "slope of the load"}},
          .make = [](const Parameters& p) -> Scene {
            const double nu = p["nu"], w2 = p["w2"], c0 = p["c0"], c1 = p["c1"];
            std::vector<double> start;
            if (c0 != w2 * p["q0"]) start.push_back(nu);
            if (c1 != w2 * p["dq0"]) start.push_back(nu + 1.0);
            return {.problem = {.components = {{nu, {p["q0"], p["dq0"]}}},
                                .rhs = [=](double t, In q, Out f) { f[0] = c0 + c1 * t - w2 * q[0]; },
                                .derivatives = DenseLinearPart{Matrix::Constant(1, 1, -w2)},
                                .end = 10.0},
                    .smoothness = {{power_lattice(start, {nu}, nu + 2.0)}},
                    .outputs = {{"q"}},
                    .reference = linear_reference({.terms = {{1.0, nu}, {w2, 0.0}},
                                                   .initial = {p["q0"], p["dq0"]},
                                                   .loads = {{c0, 0.0}, {c1, 1.0}}},
                                                  {0.0})};
          }};
}

}  // namespace fde
