// SPDX-License-Identifier: MIT
#include <boost/math/special_functions/beta.hpp>
#include <cmath>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/closed_forms/extremum.hpp"

namespace fde::bench {
namespace {

// D^alpha of this function is (2 alpha - 1) Gamma(alpha) (1 - t)^(alpha-1), the singular part of p, and its
// value at t = 1 is 1:
//   (2 alpha - 1) int_0^t ((t - s)(1 - s))^(alpha-1) ds
//     = t^alpha - (1 - alpha) (1 - t)^(2 alpha - 1) B_t(alpha, 2 - 2 alpha),
// where B_t is the incomplete beta function, by the substitution x = (t - s) / (1 - s) and integration by
// parts.
double singular_part(double alpha, double t) {
  if (alpha == 1.0) return t;
  const double beta = t > 0.0 ? boost::math::beta(alpha, 2.0 - 2.0 * alpha, t) : 0.0;
  return std::pow(t, alpha) - (1.0 - alpha) * std::pow(1.0 - t, 2.0 * alpha - 1.0) * beta;
}

// The first component of extremum_reference; the second, D^alpha y, is infinite at t = 1.
reference::Reference extremum(double alpha) {
  const reference::Reference both = reference::extremum_reference(alpha);
  return {.at = [both](double t) -> reference::ReferenceValue {
            const auto [value, bound] = both.at(t);
            return {value.head(1), bound.head(1)};
          },
          .digits = [both](double t, int digits) { return std::vector{both.digits(t, digits).front()}; },
          .evidence = both.evidence};
}

// y starts like t^alpha and ends like (1 - t)^(2 alpha - 1); both rows have y in their right-hand sides.
Smoothness smoothness(double alpha, double k) {
  if (k == 0.0) return {{{}, {}, {}}};
  const double last = alpha + 2.0;
  return {{power_lattice({alpha}, {1.0, 2.0 * alpha}, last),
           power_lattice({alpha}, {1.0, 2.0 * alpha - 1.0}, last),
           {}}};
}

// Poses y itself, as the solution of Abel's equation J^(1-alpha) y = P, where P = int_0^t p is not singular.
// With C = (2 alpha - 1) Gamma(alpha) and Pi the integral of the regular part pi of p
//   D^(1-alpha) P = y,  0 = P - c C (1 - (1 - t)^alpha)/alpha - Pi,  Pi' = pi,  tD_1^alpha pi = -k y,
// and y(1) = 1. The row of y is algebraic and constrains P. The unknown c absorbs the error of y in the last
// step, where y is like (1 - t)^(2 alpha - 1).
void pose_unsplit(Scene& scene, double alpha, double k) {
  enum : Eigen::Index { integral, y, regular, pi, c };
  const double factor = (2.0 * alpha - 1.0) * std::tgamma(alpha) / alpha;
  const auto singular = [=](double t) { return factor * (1.0 - std::pow(1.0 - t, alpha)); };
  scene.reference_problem = PosedProblem{scene.problem, scene.outputs};
  scene.problem.components = {
      {1.0 - alpha, {0.0}}, {0.0, {0.0}}, {1.0, {0.0}}, {alpha, {0.0}, Side::right}, {1.0, {}}};
  scene.problem.rhs = [=](double t, In now, Out f) {
    f << now[y], now[integral] - now[c] * singular(t) - now[regular], now[pi], -k * now[y], 0.0;
  };
  scene.problem.derivatives = DenseJacobian{[=](double t, In, OutMatrix jacobian) {
    jacobian.setZero();
    jacobian(integral, y) = jacobian(y, integral) = jacobian(regular, pi) = 1.0;
    jacobian(y, c) = -singular(t);
    jacobian(y, regular) = -1.0;
    jacobian(pi, y) = -k;
  }};
  scene.problem.conditions = [](In, In at_end, Out residual) { residual[0] = at_end[y] - 1.0; };
  scene.outputs = select_components({"y"}, {y});
  scene.smoothness = {{{1.0}, {}, {alpha + 1.0}, {alpha}, {2.0 * alpha - 1.0}}};
}

}  // namespace

// Minimum of 1/2 int_0^1 (D^alpha y)^2 + k y^2 dt. With p = D^alpha y the first variation is
//   int_0^1 p D^alpha e + k y e dt = int_0^1 e (tD_1^alpha p + k y) dt,
// with the right Riemann-Liouville derivative, for all e with e(0) = e(1) = 0. So p = -k J_-^alpha y + c (2
// alpha - 1) Gamma(alpha) (1 - t)^(alpha-1): the last term is in the kernel of that derivative and infinite
// at t = 1. With c K the part of y that it causes, the remainder eta is regular, and for it the
// Riemann-Liouville derivative equals the Caputo derivative:
//   y = c K + eta,  D^alpha eta = pi,  tD_1^alpha pi = -k y,  c' = 0,  c + eta(1) = 1.
// Without a spring eta = pi = 0 and c = 1, which schemes reproduce to rounding.
SceneFactory fractional_extremum() {
  return {
      .id = "fractional_extremum",
      .title = "Least square of a fractional derivative, with a spring",
      .source = "Agrawal 2002; Tarasov & Zaslavsky 2006, eq. 70 corrected",
      .parameters = {{"alpha",
                      0.75,
                      {.low = 0.5, .high = 1.0, .open_low = true},
                      "order of the derivative that is squared"},
                     {"k", 0.0, not_negative, "stiffness of the spring"},
                     choice("form", {"split", "whole"},
                            "whole: y itself is computed, not what is regular in it")},
      .make = [](const Parameters& parameters) -> Scene {
        const double alpha = parameters["alpha"], k = parameters["k"];
        const auto singular = [=](double t) { return k == 0.0 ? 0.0 : singular_part(alpha, t); };
        Scene scene{
            .problem = {
                .components = {{alpha, {0.0}}, {alpha, {0.0}, Side::right}, {1.0, {}}},
                .rhs = [=](double t, In y, Out f) { f << y[1], -k * (y[2] * singular(t) + y[0]), 0.0; },
                .derivatives = DenseJacobian{[=](double t, In, OutMatrix jacobian) {
                  jacobian << 0.0, 1.0, 0.0, -k, 0.0, -k * singular(t), 0.0, 0.0, 0.0;
                }},
                .end = 1.0,
                .conditions = [](In, In at_end, Out residual) { residual[0] = at_end[2] + at_end[0] - 1.0; }},
            .smoothness = smoothness(alpha, k),
            .outputs = {{"y"}, [=](double t, In y, Out columns) {
                          columns[0] = y[2] * singular_part(alpha, t) + y[0];
                        }}};
        if (k == 0.0) scene.reference = extremum(alpha);
        if (parameters.choice("form") == "whole") {
          if (alpha == 1.0) reject("alpha", alpha, "below 1 where form = whole");
          pose_unsplit(scene, alpha, k);
        }
        return scene;
      },
      .display_equations = {{"D(y, alpha)", "p"}, {"D_right(p, alpha)", "-k*y"}}};
}

}  // namespace fde::bench
