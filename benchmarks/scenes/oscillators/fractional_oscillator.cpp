// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/linear/linear_solution.hpp"

namespace fde::bench {
namespace {

// D^nu q + w2 q = c0 + c1 t + c2 t^(2-nu) / Gamma(3-nu).
struct LoadedOscillator {
  double nu, w2, q0, dq0, c0, c1, c2;

  [[nodiscard]] double load(double t) const {
    const double first = c0 + c1 * t;
    return c2 == 0.0 ? first : first + c2 * std::pow(t, 2.0 - nu) / std::tgamma(3.0 - nu);
  }

  // Q = (q0 s^(nu-1) + dq0 s^(nu-2) + c0/s + c1/s^2 + c2 s^(nu-3)) / (s^nu + w2).
  [[nodiscard]] reference::LinearTransform transform() const {
    const reference::Rational order = reference::shortest_decimal(nu);
    reference::LinearTransform transform;
    add_term(transform.characteristic, order, 1);
    add_term(transform.characteristic, 0, reference::shortest_decimal(w2));
    auto& numerator = transform.group_at(0, 1).numerators.front();
    add_term(numerator, reference::Rational(order - 1), reference::shortest_decimal(q0));
    add_term(numerator, reference::Rational(order - 2), reference::shortest_decimal(dq0));
    add_term(numerator, -1, reference::shortest_decimal(c0));
    add_term(numerator, -2, reference::shortest_decimal(c1));
    add_term(numerator, reference::Rational(order - 3), reference::shortest_decimal(c2));
    transform.generators = {1, order};
    return transform;
  }
  [[nodiscard]] reference::Reference motion() const {
    return reference::linear_reference("fractional_oscillator", [*this] { return transform(); });
  }

  [[nodiscard]] Smoothness smoothness() const {
    std::vector<double> start;
    if (c0 != w2 * q0) start.push_back(nu);
    if (c1 != w2 * dq0) start.push_back(nu + 1.0);
    if (c2 != 0.0) start.push_back(2.0);
    return {{power_lattice(start, {nu}, nu + 2.0)}};
  }
};

// The residues of Q e^(st) at the zeros w e^(+-i pi/nu) of s^nu + w2, w^nu = w2: the term k = 0, 1, 2 of the
// load is
//   (2/nu) (its factor) w^-k e^(w t cos(pi/nu)) cos(w t sin(pi/nu) - k pi/nu).
// For the initial values, k = 0 and 1, these are Tarasov & Zaslavsky's g_(nu,k) of (53).
struct Oscillation {
  LoadedOscillator oscillator;

  template <class Real>
  [[nodiscard]] std::vector<reference::ConditionedValue<Real>> operator()(const Real& t) const {
    using std::abs, std::cos, std::exp, std::pow, std::sin;
    const Real order = reference::from_shortest_decimal<Real>(oscillator.nu),
               square = reference::from_shortest_decimal<Real>(oscillator.w2);
    const Real w = pow(square, Real(1 / order)), angle = reference::pi<Real>() / order;
    const std::array<Real, 3> factors{reference::from_shortest_decimal<Real>(oscillator.q0) -
                                          reference::from_shortest_decimal<Real>(oscillator.c0) / square,
                                      (reference::from_shortest_decimal<Real>(oscillator.dq0) -
                                       reference::from_shortest_decimal<Real>(oscillator.c1) / square) /
                                          w,
                                      reference::from_shortest_decimal<Real>(oscillator.c2) / (w * w)};
    Real sum = 0, size = 0;
    for (int k = 0; k < 3; ++k) {
      const Real& factor = factors.at(static_cast<std::size_t>(k));
      sum += factor * cos(Real(w * t * sin(angle) - k * angle));
      size += abs(factor);
    }
    const Real amplitude = 2 * exp(Real(w * t * cos(angle))) / order;
    return {{Real(amplitude * sum), Real(amplitude * size * (4 + 2 * w * t))}};
  }
};

// Columns q, f = q - g, g.
reference::Reference with_parts(const LoadedOscillator& of) {
  const auto motion = of.motion(), oscillation = reference::closed_form(Oscillation{of});
  return {.at = [motion, oscillation](double t) -> reference::ReferenceValue {
            const auto [q, of_q] = motion.at(t);
            const auto [g, of_g] = oscillation.at(t);
            return {Eigen::Vector3d(q[0], q[0] - g[0], g[0]),
                    Eigen::Vector3d(of_q[0], of_q[0] + of_g[0], of_g[0])};
          },
          .evidence = motion.evidence};
}

Outputs parts(const LoadedOscillator& of) {
  return {{"q", "f", "g"}, [oscillation = Oscillation{of}](double t, In q, Out columns) {
            const auto g = static_cast<double>(oscillation(static_cast<long double>(t)).front().value);
            columns << q[0], q[0] - g, g;
          }};
}

}  // namespace

// The load of Tarasov & Zaslavsky's (49), nu = alpha - 1, is q''(0) t^(3-alpha)/Gamma(4-alpha) + w2 (q(0) +
// q'(0) t): the printed equation has q(0) in place of q''(0). Without a load, q = q(0) E_nu(-w2 t^nu) + q'(0)
// t E_{nu,2}(-w2 t^nu), which is (51) to (53) with nu in place of alpha; the convolution with the load in the
// printed (50) and (54) lacks a factor 1/w2. q is the sum of g, which oscillates and decays exponentially,
// and f, which decays like a power of t.
SceneFactory fractional_oscillator() {
  return {.id = "fractional_oscillator",
          .title = "Fractional oscillator",
          .source = "Tarasov & Zaslavsky 2006, eqs 49-54 (corrected)",
          .parameters = {{"nu", 1.5, {.low = 1.0, .high = 2.0, .open_low = true}, "order"},
                         {"w2", 1.0, any_number, "square of the frequency"},
                         {"q0", 1.0, any_number, "q(0)"},
                         {"dq0", 0.0, any_number, "q'(0)"},
                         {"c0", 0.0, any_number, "constant load"},
                         {"c1", 0.0, any_number, "slope of the load"},
                         {"c2", 0.0, any_number, "load t^(2-nu)/Gamma(3-nu), the q''(0) of eq. 49"},
                         choice("parts", {"together", "apart"},
                                "apart: columns f and g as well, the parts of q in eqs 52 and 53")},
          .make = [](const Parameters& p) -> Scene {
            const LoadedOscillator of{.nu = p["nu"],
                                      .w2 = p["w2"],
                                      .q0 = p["q0"],
                                      .dq0 = p["dq0"],
                                      .c0 = p["c0"],
                                      .c1 = p["c1"],
                                      .c2 = p["c2"]};
            const bool apart = p.choice("parts") == "apart";
            if (apart && !(of.w2 > 0.0)) reject("w2", of.w2, "above 0 where parts = apart");
            return {.problem = {.components = {{of.nu, {of.q0, of.dq0}}},
                                .rhs = [of](double t, In q, Out f) { f[0] = of.load(t) - of.w2 * q[0]; },
                                .derivatives = DenseLinearPart{Matrix::Constant(1, 1, -of.w2)},
                                .end = 10.0},
                    .smoothness = of.smoothness(),
                    .outputs = apart ? parts(of) : Outputs{{"q"}},
                    .reference = apart ? with_parts(of) : of.motion()};
          },
          .equations = {{.unknown = "q",
                         .terms = {{"1", "nu"}},
                         .rhs = "-w2*q + c0 + c1*t + c2*t^(2 - nu)/gamma(3 - nu)",
                         .initial = {"q0", "dq0"}}}};
}

}  // namespace fde::bench
