// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "fdebench/benchmarks/scenes/oscillators/damping.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/problem/chain_problem.hpp"

namespace fde::bench {
namespace {

// A swinging mass on a spring: length L r, r = 1 + xi. With D the damping terms of each unknown,
//   phi'' + D(phi) / r^2 = turn,   xi'' + D(xi) = pull.
// If D(phi) has a term m phi'' of order 2, the first equation is multiplied by (1 + m) r^2 / (r^2 + m):
//   (1 + m) phi'' + (1 + m) / (r^2 + m) (the other terms of D(phi)) = (1 + m) r^2 / (r^2 + m) turn.
struct Spring {
  enum : Eigen::Index { phi, dphi, xi, dxi };
  using State = Eigen::Vector4d;
  double gravity, stiffness;  // g/L, K/m
  double inertia;             // m

  static double length(const State& s) { return 1.0 + s[xi]; }
  // r^2 / (r^2 + m), exactly 1 if m = 0.
  [[nodiscard]] double share(const State& s) const {
    const double square = length(s) * length(s);
    return square / (square + inertia);
  }
  [[nodiscard]] double damping_factor(const State& s) const {
    return (1.0 + inertia) / (length(s) * length(s) + inertia);
  }
  [[nodiscard]] double turning_force(const State& s) const { return (1.0 + inertia) * share(s) * turn(s); }

  [[nodiscard]] double turn(const State& s) const {
    return -(gravity * std::sin(s[phi]) + 2.0 * s[dphi] * s[dxi]) / length(s);
  }
  // The gradient of turning_force - damping_factor * damping with respect to the state.
  [[nodiscard]] State turn_gradient(const State& s, double damping) const {
    const double r = length(s), part = share(s);
    const State by_turn{-gravity * std::cos(s[phi]) / r, -2.0 * s[dxi] / r,
                        (gravity * std::sin(s[phi]) + 2.0 * s[dphi] * s[dxi]) / (r * r), -2.0 * s[dphi] / r};
    State gradient = part * by_turn;
    gradient[xi] += part * part * (2.0 * (damping + inertia * turn(s)) / (r * r * r));
    return (1.0 + inertia) * gradient;
  }

  [[nodiscard]] double pull(const State& s) const {
    return gravity * std::cos(s[phi]) + length(s) * s[dphi] * s[dphi] - stiffness * s[xi];
  }
  [[nodiscard]] State pull_gradient(const State& s) const {
    return {-gravity * std::sin(s[phi]), 2.0 * length(s) * s[dphi], s[dphi] * s[dphi] - stiffness, 0.0};
  }

  // Energy per m L^2, eq. 6.4 with K/m in place of the printed K/(m L^2).
  [[nodiscard]] double energy(const State& s) const {
    const double r = length(s);
    return 0.5 * (r * r * s[dphi] * s[dphi] + s[dxi] * s[dxi]) - gravity * r * std::cos(s[phi]) +
           0.5 * stiffness * s[xi] * s[xi];
  }
};

Problem problem_of(const Spring& spring, const DampedUnknown& phi, const DampedUnknown& xi) {
  const std::array rows{phi.row(), phi.row_of_velocity(), xi.row(), xi.row_of_velocity()};
  const MultiTermEquation turning{
      .chain = phi.chain(),
      .force = [=](double, In y) { return spring.turning_force(y(rows)); },
      .factor = [=](double, In y) { return spring.damping_factor(y(rows)); },
      .derivatives = ForceGradient{[=](double, In y, double damping, Out gradient) {
        gradient(rows) += spring.turn_gradient(y(rows), damping);
      }}};
  const MultiTermEquation pulling{.chain = xi.chain(),
                                  .force = [=](double, In y) { return spring.pull(y(rows)); },
                                  .derivatives = ForceGradient{[=](double, In y, double, Out gradient) {
                                    gradient(rows) += spring.pull_gradient(y(rows));
                                  }}};
  Problem problem = chain_problem({turning, pulling}, 20.0);
  problem.domain = {.edge = "r = L (1 + xi) = 0",
                    .margin = [=](double, In y) { return Spring::length(y(rows)); }};
  return problem;
}

}  // namespace

SceneFactory extensible_pendulum() {
  return {
      .id = "extensible_pendulum",
      .title = "Extensible pendulum with fractional damping",
      .source = "Yin, Liu & Anh 2007, eqs 6.1-6.8, example 2; energy eq. 6.4 (corrected)",
      .parameters = damping_parameters({{"mu", 0.1, not_negative, "damping of phi, order alpha"},
                                        {"lambda", 0.1, not_negative, "damping of phi, order 1"},
                                        {"nu", 0.1, not_negative, "damping of phi, order beta"},
                                        {"g_over_L", 1.0, any_number, "gravity over length"},
                                        {"phi0", 1.0, any_number, "phi(0)"},
                                        {"dphi0", 0.0, any_number, "phi'(0)"},
                                        {"K_over_m", 1.3, not_negative, "stiffness of the spring over mass"},
                                        {"mu1", 0.2, not_negative, "damping of xi, order alpha"},
                                        {"lambda1", 0.1, not_negative, "damping of xi, order 1"},
                                        {"nu1", 0.1, not_negative, "damping of xi, order beta"},
                                        {"xi0", 0.0, {.low = -1.0, .open_low = true}, "xi(0)"},
                                        {"dxi0", 0.0, any_number, "xi'(0)"}}),
      .make = [](const Parameters& p) -> Scene {
        const DampedUnknown phi("phi", p, {p["mu"], p["lambda"], p["nu"]}, {p["phi0"], p["dphi0"]});
        const DampedUnknown xi("xi", p, {p["mu1"], p["lambda1"], p["nu1"]}, {p["xi0"], p["dxi0"]},
                               phi.next());
        const Spring spring{.gravity = p["g_over_L"], .stiffness = p["K_over_m"], .inertia = phi.inertia()};
        const Problem problem = problem_of(spring, phi, xi);
        auto discontinuities = phi.discontinuities();
        std::ranges::copy(xi.discontinuities(), std::back_inserter(discontinuities));
        return {.problem = problem,
                .smoothness = smoothness_of_chains({phi.chain(), xi.chain()}),
                .outputs = outputs_of({phi, xi}, problem),
                .energy = {.value =
                               [=](In c) {
                                 return spring.energy({phi.u(c), phi.du(c), xi.u(c), xi.du(c)});
                               },
                           .power = [=](double, In c) { return phi.power(c) + xi.power(c); }},
                .discontinuities = std::move(discontinuities)};
      },
      .equations = {
          {.unknown = "phi",
           .terms = {{"1", "2"}},
           .rhs = "-(g_over_L*sin(phi) + 2*D(phi,1)*D(xi,1))/(1 + xi) - (mu*tau^alpha*D(phi,alpha) + "
                  "lambda*tau*D(phi,1) + nu*tau^beta*D(phi,beta))/(1 + xi)^2",
           .initial = {"phi0", "dphi0"}},
          {.unknown = "xi",
           .terms = {{"1", "2"}, {"mu1*tau^alpha", "alpha"}, {"lambda1*tau", "1"}, {"nu1*tau^beta", "beta"}},
           .rhs = "g_over_L*cos(phi) + (1 + xi)*D(phi,1)^2 - K_over_m*xi",
           .initial = {"xi0", "dxi0"}}}};
}

}  // namespace fde::bench
