// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/programs/expressions/systems.hpp"

#include <cmath>

namespace fde::bench {
namespace {

// Rows phi, D^0.5 phi, phi', D^1.5 phi.
WrittenTwice pendulum() {
  const double mu = 0.06 * std::pow(0.8, 1.5), lambda = 0.1 * 0.8, nu = 0.1 * std::sqrt(0.8);
  return {.name = "pendulum",
          .file = R"toml(end = 20.0
[unknown.phi]
terms = [[1.0, 2.0], ["0.06*0.8^1.5", 1.5], ["0.1*0.8", 1.0], ["0.1*0.8^0.5", 0.5]]
rhs = "-sin(phi)"
initial = [1.0, -0.3]
)toml",
          .rhs =
              [=](double, In y, Out f) {
                f[0] = y[1];
                f[1] = y[2];
                f[2] = y[3];
                f[3] = -std::sin(y[0]) - (nu * y[1] + lambda * y[2] + mu * y[3]);
              },
          .jacobian =
              [=](double, In y, OutMatrix jacobian) {
                jacobian << 0.0, 1.0, 0.0, 0.0,  //
                    0.0, 0.0, 1.0, 0.0,          //
                    0.0, 0.0, 0.0, 1.0,          //
                    -std::cos(y[0]), -nu, -lambda, -mu;
              }};
}

WrittenTwice brusselator() {
  return {.name = "brusselator",
          .file = R"toml(end = 50.0
[unknown.x]
order = 0.8
rhs = "1 - (4 + 1)*x + x^2*y"
initial = [1.2]
[unknown.y]
order = 0.8
rhs = "4*x - x^2*y"
initial = [2.8]
)toml",
          .rhs =
              [](double, In y, Out f) {
                const double made = y[0] * y[0] * y[1];
                f[0] = 1.0 - 5.0 * y[0] + made;
                f[1] = 4.0 * y[0] - made;
              },
          .jacobian =
              [](double, In y, OutMatrix jacobian) {
                const double by_x = 2.0 * y[0] * y[1], by_y = y[0] * y[0];
                jacobian << by_x - 5.0, by_y, 4.0 - by_x, -by_y;
              }};
}

// Rows y, D^0.5 y, y', D^1.5 y.
WrittenTwice bagley_torvik() {
  return {.name = "bagley_torvik",
          .file = R"toml(end = 16.0
[unknown.y]
terms = [[1.0, 2.0], [0.5, 1.5]]
rhs = "8*step(1 - t) - 0.5*y"
initial = [0.0, 0.0]
)toml",
          .rhs = [](double t, In y, Out f) {
            const double load = t < 1.0 ? 8.0 : t == 1.0 ? 4.0 : 0.0;
            f[0] = y[1];
            f[1] = y[2];
            f[2] = load - 0.5 * y[0] - 0.5 * y[2];
          }};
}

// Rows x, D^0.5 x, x'.
WrittenTwice duffing() {
  return {.name = "duffing",
          .file = R"toml(end = 20.0
[unknown.x]
terms = [[1.0, 1.8], [0.1, 0.5]]
rhs = "0.3*cos(1.1*t) - x - x^3"
initial = [0.2, 0.0]
)toml",
          .rhs =
              [](double t, In y, Out f) {
                f[0] = y[1];
                f[1] = y[2];
                f[2] = 0.3 * std::cos(1.1 * t) - y[0] - y[0] * y[0] * y[0] - 0.1 * y[1];
              },
          .jacobian =
              [](double, In y, OutMatrix jacobian) {
                jacobian << 0.0, 1.0, 0.0,  //
                    0.0, 0.0, 1.0,          //
                    -1.0 - 3.0 * y[0] * y[0], -0.1, 0.0;
              }};
}

WrittenTwice van_der_pol() {
  return {.name = "van_der_pol",
          .file = R"toml(end = 20.0
[unknown.x]
order = 0.9
rhs = "v"
initial = [2.0]
[unknown.v]
order = 0.9
rhs = "2*(1 - x^2)*v - x"
initial = [0.0]
)toml",
          .rhs =
              [](double, In y, Out f) {
                f[0] = y[1];
                f[1] = 2.0 * (1.0 - y[0] * y[0]) * y[1] - y[0];
              },
          .jacobian =
              [](double, In y, OutMatrix jacobian) {
                jacobian << 0.0, 1.0, -4.0 * y[0] * y[1] - 1.0, 2.0 * (1.0 - y[0] * y[0]);
              }};
}

// Two coupled pendulums of orders 0.9, with sines, cosines and powers.
WrittenTwice coupled_angles() {
  return {.name = "coupled_angles",
          .file = R"toml(end = 10.0
[unknown.a]
order = 0.9
rhs = "v"
initial = [0.7]
[unknown.b]
order = 0.9
rhs = "w"
initial = [-0.4]
[unknown.v]
order = 0.9
rhs = "-sin(a) - 0.5*cos(a)*sin(b) - 0.1*v^3"
initial = [0.0]
[unknown.w]
order = 0.9
rhs = "-sin(b) - 0.5*cos(b)*sin(a) - 0.1*(1 + w^2)^1.5"
initial = [0.2]
)toml",
          .rhs =
              [](double, In y, Out f) {
                const double sin_a = std::sin(y[0]), cos_a = std::cos(y[0]);
                const double sin_b = std::sin(y[1]), cos_b = std::cos(y[1]);
                f[0] = y[2];
                f[1] = y[3];
                f[2] = -sin_a - 0.5 * cos_a * sin_b - 0.1 * (y[2] * y[2] * y[2]);
                f[3] = -sin_b - 0.5 * cos_b * sin_a - 0.1 * std::pow(1.0 + y[3] * y[3], 1.5);
              },
          .jacobian =
              [](double, In y, OutMatrix jacobian) {
                const double sin_a = std::sin(y[0]), cos_a = std::cos(y[0]);
                const double sin_b = std::sin(y[1]), cos_b = std::cos(y[1]);
                jacobian << 0.0, 0.0, 1.0, 0.0,                                                   //
                    0.0, 0.0, 0.0, 1.0,                                                           //
                    -cos_a + 0.5 * sin_a * sin_b, -0.5 * cos_a * cos_b, -0.3 * y[2] * y[2], 0.0,  //
                    -0.5 * cos_b * cos_a, -cos_b + 0.5 * sin_b * sin_a, 0.0,
                    -0.3 * y[3] * std::sqrt(1.0 + y[3] * y[3]);
              }};
}

}  // namespace

const std::vector<WrittenTwice>& systems_written_twice() {
  static const std::vector<WrittenTwice> systems{pendulum(), brusselator(), bagley_torvik(),
                                                 duffing(),  van_der_pol(), coupled_angles()};
  return systems;
}

}  // namespace fde::bench
