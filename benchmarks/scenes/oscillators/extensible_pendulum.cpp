#include <algorithm>
#include <cmath>
#include <iterator>

#include "problem/chain.hpp"
#include "scenes/oscillators/damping.hpp"
#include "scenes/scene.hpp"

namespace fde {
namespace {

// The two chains side by side: phi's components first, then xi's.
struct Spring {
  Chain phi, xi;
  double gravity, stiffness;  // g/L, K/m

  [[nodiscard]] auto of_phi(In y) const { return y.head(phi.size()); }
  [[nodiscard]] auto of_xi(In y) const { return y.tail(xi.size()); }

  void rhs(In y, Out f) const {
    const auto a = of_phi(y), b = of_xi(y);
    const double r = 1.0 + b[0], dphi = a[*phi.node(1.0)], dxi = b[*xi.node(1.0)];
    const double turn = -(gravity * std::sin(a[0]) + 2.0 * dphi * dxi) / r;
    const double pull = gravity * std::cos(a[0]) + r * dphi * dphi - stiffness * b[0];
    Chain::links(a, phi.highest(a, turn, 1.0 / (r * r)), f.head(phi.size()));
    Chain::links(b, xi.highest(b, pull), f.tail(xi.size()));
  }

  void jacobian(In y, OutMatrix jacobian) const {
    const auto a = of_phi(y), b = of_xi(y);
    const auto at_dphi = *phi.node(1.0), at_xi = phi.size(), at_dxi = phi.size() + *xi.node(1.0);
    const double r = 1.0 + b[0], dphi = a[at_dphi], dxi = y[at_dxi];
    jacobian.setZero();
    jacobian.diagonal(1).setOnes();
    auto turn = jacobian.row(phi.size() - 1);
    auto pull = jacobian.row(y.size() - 1);
    Vec gradient(phi.size());
    phi.highest_gradient(-gravity * std::cos(a[0]) / r, 1.0 / (r * r), gradient);
    turn.head(phi.size()) = gradient.transpose();
    turn.tail(xi.size()).setZero();
    turn[at_dphi] -= 2.0 * dxi / r;
    turn[at_dxi] -= 2.0 * dphi / r;
    turn[at_xi] += (gravity * std::sin(a[0]) + 2.0 * dphi * dxi) / (r * r) + 2.0 * phi.terms(a) / (r * r * r);
    gradient.resize(xi.size());
    xi.highest_gradient(dphi * dphi - stiffness, 1.0, gradient);
    pull.tail(xi.size()) = gradient.transpose();
    pull[0] -= gravity * std::sin(a[0]);
    pull[at_dphi] += 2.0 * r * dphi;
  }

  [[nodiscard]] double energy(double u, double du, double length, double stretching) const {
    const double r = 1.0 + length;
    return 0.5 * (r * r * du * du + stretching * stretching) - gravity * r * std::cos(u) +
           0.5 * stiffness * length * length;
  }
};

}  // namespace

// A mass on a spring that swings: length r = L (1 + xi). Energy per m L^2, eq. 6.4 with K/m for the printed
// K/(m L^2).
SceneMaker extensible_pendulum() {
  auto parameters = damping_parameters();
  parameters.insert(parameters.end(), {{"mu", 0.1, not_negative, "damping of phi, order alpha"},
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
                                       {"dxi0", 0.0, any_number, "xi'(0)"}});
  return {.id = "extensible_pendulum",
          .title = "Extensible pendulum with fractional damping",
          .source = "Yin, Liu & Anh 2007, eqs 6.1-6.8, example 2; energy eq. 6.4 (corrected)",
          .parameters = parameters,
          .make = [](const Parameters& p) -> Scene {
            const auto of_phi = damping_terms(p, p["mu"], p["lambda"], p["nu"]);
            const auto of_xi = damping_terms(p, p["mu1"], p["lambda1"], p["nu1"]);
            const Spring spring{.phi = Chain({1.0, 2.0}, of_phi, {p["phi0"], p["dphi0"]}),
                                .xi = Chain({1.0, 2.0}, of_xi, {p["xi0"], p["dxi0"]}),
                                .gravity = p["g_over_L"],
                                .stiffness = p["K_over_m"]};
            auto components = spring.phi.components();
            std::ranges::copy(spring.xi.components(), std::back_inserter(components));
            const DampedColumns phi(of_phi, "phi"), xi(of_xi, "xi", std::ssize(phi.names));
            auto names = phi.names;
            auto picks = phi.components(spring.phi);
            std::ranges::copy(xi.names, std::back_inserter(names));
            std::ranges::copy(xi.components(spring.xi, spring.phi.size()), std::back_inserter(picks));
            return {.problem = {.components = components,
                                .rhs = [=](double, In y, Out f) { spring.rhs(y, f); },
                                .derivatives = DenseJacobian{[=](double, In y, OutMatrix jacobian) {
                                  spring.jacobian(y, jacobian);
                                }},
                                .end = 20.0,
                                .domain = {.edge = "r = L (1 + xi) = 0",
                                           .margin = [=](double, In y) { return 1.0 + spring.of_xi(y)[0]; }}},
                    .smoothness = chain_smoothness({spring.phi, spring.xi}),
                    .outputs = picked(names, picks),
                    .energy = {
                        .value = [=](In c) { return spring.energy(phi.u(c), phi.du(c), xi.u(c), xi.du(c)); },
                        .power = [=](double, In c) { return phi.power(c) + xi.power(c); }}};
          }};
}

}  // namespace fde
