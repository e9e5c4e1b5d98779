// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "fdebench/benchmarks/scenes/two_sided/plane_mechanics.hpp"

namespace fde::bench {
namespace {

struct Coefficients {
  double kappa, epsilon;

  // f = A.q' with A = (1 + kappa q1 + epsilon w, 1), w = D^alpha q1.
  [[nodiscard]] Plane at(double q1, double w) const { return {1.0 + kappa * q1 + epsilon * w, 1.0}; }
};

// The manufactured solution, a sum of powers: q1' = 15/16 t^2 (2-t)^2 vanishes at both ends to an order that
// gives w and r two derivatives, q2' = -A1 q1' satisfies f = 0, mu = 1/2 + t/4 is chosen, p = q' + mu A.
struct ManufacturedMotion {
  ManufacturedMotion(const Coefficients& coefficients, double alpha) {
    const auto one = SumOfPowers::polynomial({1.0});
    q[0] = SumOfPowers::polynomial({0.5, 0.0, 0.0, 1.25, -0.9375, 0.1875});
    v[0] = q[0].derivative(1.0);
    w = q[0].derivative(alpha);
    const auto a = one + coefficients.kappa * q[0] + coefficients.epsilon * w;
    v[1] = -1.0 * a * v[0];
    q[1] = SumOfPowers::polynomial({1.0}) + v[1].derivative(-1.0);
    p[0] = v[0] + mu * a;
    p[1] = v[1] + mu;
    r = coefficients.epsilon * (mu * v[0]).reversed(manufactured_end).derivative(alpha - 1.0);
    push = {p[0].derivative(1.0) + (-coefficients.kappa) * mu * v[0], p[1].derivative(1.0)};
    r_slope = -1.0 * r.derivative(1.0);
  }

  // The forcing term of pi' for this solution, in addition to grad u.
  [[nodiscard]] Plane force(double t) const {
    return {push[0].at(t) + r_slope.at(manufactured_end - t), push[1].at(t)};
  }

  std::array<SumOfPowers, 2> q, v, p, push;
  SumOfPowers w, r, r_slope;  // the latter two as functions of end - t
  SumOfPowers mu = SumOfPowers::polynomial({0.5, 0.25});
};

// Components q1, q2, w, r, pi1, pi2.
struct Hamilton {
  enum : Eigen::Index { q = 0, w = 2, r = 3, pi = 4 };
  static constexpr int size = 6;
  Coefficients coefficients;
  Plane stiffness;
  double end = manufactured_end;
  std::function<Plane(double t)> force{};  // in addition to -grad u

  struct State {
    Plane v, p, a;
    double mu;
  };
  [[nodiscard]] State state(In y) const {
    const Plane p(y[pi] - y[r], y[pi + 1]), a = coefficients.at(y[q], y[w]);
    const double mu = a.dot(p) / a.squaredNorm();
    return {p - mu * a, p, a, mu};
  }

  // dA.v/dq1 = kappa v1 and dA.v/dw = epsilon v1.
  void rhs(double t, In y, Out f) const {
    const auto [v, p, a, mu] = state(y);
    const Plane push = force(t);
    f.segment<2>(q) = v;
    f[w] = v[0];
    f[r] = mu * coefficients.epsilon * v[0];
    f.segment<2>(pi) = stiffness.cwiseProduct(y.segment<2>(q)) - push;
    f[pi] -= mu * coefficients.kappa * v[0];
  }

  // With respect to A1, p1 and p2: d mu = (p1 - 2 mu A1, A1, 1) / A^2 and dv = dp - A dmu - mu dA. A1 depends
  // on q1 and w, p1 on pi1 and r.
  void jacobian(In y, OutMatrix result) const {
    const auto [v, p, a, mu] = state(y);
    const Eigen::RowVector3d by_mu = Eigen::RowVector3d(p[0] - 2.0 * mu * a[0], a[0], 1.0) / a.squaredNorm();
    Eigen::Matrix<double, 3, size> arguments = Eigen::Matrix<double, 3, size>::Zero();
    arguments(0, q) = coefficients.kappa;
    arguments(0, w) = coefficients.epsilon;
    arguments(1, pi) = arguments(2, pi + 1) = 1.0;
    arguments(1, r) = -1.0;
    Eigen::Matrix<double, 2, 3> by_v = -a * by_mu;
    by_v(0, 0) -= mu;
    by_v(0, 1) += 1.0;
    by_v(1, 2) += 1.0;
    const Eigen::RowVector3d by_product = by_mu * v[0] + mu * by_v.row(0);  // of mu v1
    result.setZero();
    result.middleRows<2>(q) = by_v * arguments;
    result.row(w) = by_v.row(0) * arguments;
    result.row(r) = coefficients.epsilon * by_product * arguments;
    result.row(pi) = -coefficients.kappa * by_product * arguments;
    result(pi, q) += stiffness[0];
    result(pi + 1, q + 1) += stiffness[1];
  }

  void columns(double /*t*/, In y, Out result) const {
    const auto [v, p, a, mu] = state(y);
    result << y.head<2>(), v, y[w], y[r], p, mu;
  }

  [[nodiscard]] double energy(In columns) const {
    return columns.segment<2>(2).squaredNorm() / 2 + stiffness.dot(columns.head<2>().cwiseAbs2()) / 2;
  }
  [[nodiscard]] double constraint(double /*t*/, In columns) const {
    return coefficients.at(columns[0], columns[4]).dot(columns.segment<2>(2));
  }
};

const std::vector<std::string> columns{"q1", "q2", "v1", "v2", "w1", "r1", "p1", "p2", "mu"};

// `last`: the values of pi1 and pi2 at the end, or none if unknown.
std::vector<Component> components(double alpha, const Plane& start,
                                  const std::array<std::vector<double>, 2>& last) {
  const double memory = 1.0 - alpha;
  return {
      {1.0, {start[0]}},           {1.0, {start[1]}},          {memory, {0.0}}, {memory, {0.0}, Side::right},
      {1.0, last[0], Side::right}, {1.0, last[1], Side::right}};
}

// The manufactured problem: a force is added to p', and none to q', so f = 0.
Scene manufactured_scene(Hamilton system, double alpha) {
  const ManufacturedMotion m(system.coefficients, alpha);
  system.force = [=, k = system.stiffness](double t) -> Plane {
    return m.force(t) + k.cwiseProduct(point_at(m.q, t));
  };
  const Plane last = point_at(m.p, manufactured_end), start{m.q[0].at(0.0), m.q[1].at(0.0)};
  Scene scene = two_sided_scene(system, components(alpha, start, {std::vector{last[0]}, {last[1]}}), columns);
  scene.reference = manufactured_reference(
      {{m.q[0]}, {m.q[1]}, {m.v[0]}, {m.v[1]}, {m.w}, {m.r, Side::right}, {m.p[0]}, {m.p[1]}, {m.mu}},
      manufactured_end);
  scene.memory_columns = {{4, 2, alpha}};
  // Powers of right rows are in end - t. At the end p is smooth; pi = p + r also has the powers of r.
  auto first = m.r.powers();
  first.push_back(1.0);
  std::ranges::sort(first);
  scene.smoothness = {{m.q[0].powers(), m.q[1].powers(), m.w.powers(), m.r.powers(), first, {1.0, 2.0, 3.0}}};
  return scene;
}

// The problem with given loads and end values: p(T), or q1(T) and p2(T) with p1(T) unknown. q2(T) is not
// offered beside q1(T), because the constraint nearly determines it.
Scene prescribed_scene(Hamilton system, double alpha, const Parameters& p) {
  const PrescribedLoads loads(p);
  const Plane last(p["end1"], p["end2"]);
  const bool place = p.choice("ends") == "place";
  system.end = loads.end;
  system.force = [loads](double) { return loads.force; };
  const std::array at_end{place ? std::vector<double>{} : std::vector{last[0]}, std::vector{last[1]}};
  Scene scene = two_sided_scene(system, components(alpha, loads.start, at_end), columns);
  if (place) {
    scene.problem.conditions = [at = last[0]](In, In y, Out residual) { residual[0] = y[0] - at; };
  }
  scene.memory_columns = {{4, 2, alpha}};
  const auto [regular, remembered] = TwoSidedStartExponents(alpha);
  scene.smoothness = {{regular, regular, remembered, remembered, regular, regular}};
  return scene;
}

}  // namespace

// Extremum of int 1/2 q'^2 - u + mu f dt with q(0) and, in place of q(T), p(T) given. The equations are
//   q' = p - mu A,  mu = A.p / A^2,
//   p_k' = -u_k + mu q'.dA/dq_k + tD_T^alpha g_k,  g_k = mu q'.dA/dw_k,
// where tD_T^alpha is the right Riemann-Liouville derivative, -d/dt of r_k = J_-^(1-alpha) g_k. So pi = p + r
// has a regular right-hand side, and r is a right row: tD_T^(1-alpha) r_k = g_k, r_k(T) = 0.
SceneFactory fractional_hamilton() {
  return {
      .id = "fractional_hamilton",
      .title = "Hamilton's equations with a fractional constraint",
      .source = "Tarasov & Zaslavsky 2006, eqs 79-86 corrected; manufactured, or with given loads and ends",
      .parameters =
          concatenated({{{"alpha", 0.5, order_below_one, "order of the constraint"},
                         {"kappa", 0.5, any_number, "of q1 in the constraint"},
                         {"epsilon", 0.5, any_number, "of D^alpha q1 in the constraint"},
                         {"k1", 1.0, any_number, "stiffness of q1"},
                         {"k2", 2.0, any_number, "stiffness of q2"}},
                        {motion_choice()},
                        prescribed_load_parameters(),
                        {choice("ends", {"momentum", "place"}, "what is given at T: p, or q1 and p2"),
                         {"end1", 0.2, any_number, "p1(T) or q1(T)"},
                         {"end2", -0.1, any_number, "p2(T)"}}}),
      .make = [](const Parameters& p) -> Scene {
        const Hamilton system{.coefficients = {p["kappa"], p["epsilon"]}, .stiffness = {p["k1"], p["k2"]}};
        return has_prescribed_loads(p) ? prescribed_scene(system, p["alpha"], p)
                                       : manufactured_scene(system, p["alpha"]);
      },
      .display_equations = {{"D(q, 1)", "p - mu*A"},
                            {"D(p_k, 1)", "-du_over_dq_k + mu*dA_over_dq_k*D(q, 1) - D(r_k, 1)"},
                            {"r_k", "J_right(mu*dA_over_dw_k*D(q, 1), 1 - alpha)"},
                            {"A*D(q, 1)", "0"}}};
}

}  // namespace fde::bench
