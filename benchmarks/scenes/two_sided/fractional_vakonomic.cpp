// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/two_sided/plane_mechanics.hpp"

namespace fde::bench {
namespace {

// u = (k1 q1^2 + k2 q2^2)/2, f = a.v + b.w + c.r - F(t) with w = D^alpha q and r = tD_T^alpha q.
// Components q1, q2, w1, w2, r1, r2, rho = J_-^(1-alpha) mu, ell = J^(1-alpha) mu, pi1, pi2.
struct ConstrainedExtremum {
  enum : Eigen::Index { q = 0, w = 2, r = 4, rho = 6, ell = 7, pi = 8 };
  static constexpr int size = 10;
  Plane a, b, c, stiffness;
  double end = 1.0;
  std::function<double(double t)> drive{};  // F
  Plane force{0.0, 0.0};

  struct State {
    Plane v;
    double mu;
  };
  // p = pi - b rho + c ell = v + mu a, and mu follows from f = 0.
  [[nodiscard]] State state(double load, In y) const {
    const Plane p = y.segment<2>(pi) - b * y[rho] + c * y[ell];
    const double mu = (a.dot(p) + b.dot(y.segment<2>(w)) + c.dot(y.segment<2>(r)) - load) / a.squaredNorm();
    return {p - mu * a, mu};
  }

  [[nodiscard]] Vec rates(double load, const Plane& given_force, In y) const {
    const auto [v, mu] = state(load, y);
    Vec f(size);
    f[rho] = f[ell] = mu;
    f.segment<2>(q) = f.segment<2>(w) = v;
    f.segment<2>(r) = -v;
    f.segment<2>(pi) = stiffness.cwiseProduct(y.segment<2>(q)) - given_force;
    return f;
  }
  void rhs(double t, In y, Out f) const { f = rates(drive(t), force, y); }
  // The rates are linear in y.
  void jacobian(In /*y*/, OutMatrix result) const {
    for (Eigen::Index j = 0; j < size; ++j) result.col(j) = rates(0.0, Plane::Zero(), Vec::Unit(size, j));
  }

  // The last column: the component across a of c ell - b rho, by which the momentum differs from that of the
  // motion.
  void columns(double t, In y, Out result) const {
    const auto [v, mu] = state(drive(t), y);
    result << y.head<2>(), v, y.segment<4>(w), mu,
        perpendicular(a).dot(c) * y[ell] - perpendicular(a).dot(b) * y[rho];
  }
  [[nodiscard]] double energy(In columns) const {
    return columns.segment<2>(2).squaredNorm() / 2 + stiffness.dot(columns.head<2>().cwiseAbs2()) / 2;
  }
  [[nodiscard]] double constraint(double t, In columns) const {
    return a.dot(columns.segment<2>(2)) + b.dot(columns.segment<2>(4)) + c.dot(columns.segment<2>(6)) -
           drive(t);
  }
};

Scene scene_of(ConstrainedExtremum system, const Parameters& p) {
  const double alpha = p["alpha"], memory = 1.0 - alpha;
  const PrescribedLoads loads(p);
  system.end = loads.end;
  system.drive = constraint_drive(p);
  system.force = loads.force;
  Scene scene = two_sided_scene(system,
                                {{1.0, {loads.start[0]}},
                                 {1.0, {loads.start[1]}},
                                 {memory, {0.0}},
                                 {memory, {0.0}},
                                 {memory, {0.0}, Side::right},
                                 {memory, {0.0}, Side::right},
                                 {memory, {0.0}, Side::right},
                                 {memory, {0.0}},
                                 {1.0, {}, Side::right},
                                 {1.0, {}, Side::right}},
                                {"q1", "q2", "v1", "v2", "w1", "w2", "r1", "r2", "mu", "defect"});
  scene.problem.conditions = [e = perpendicular(system.a), along_a = Plane(system.a.normalized()),
                              first = p.choice("ends") == "place" ? ConstrainedExtremum::q
                                                                  : ConstrainedExtremum::pi,
                              of_e = p["across"], along = p["along"]](In, In y, Out residual) {
    residual << e.dot(y.segment<2>(first)) - of_e, along_a.dot(y.segment<2>(ConstrainedExtremum::pi)) - along;
  };
  const auto [regular, remembered] = TwoSidedStartExponents(alpha);
  scene.smoothness = {{regular, regular, remembered, remembered, remembered, remembered, remembered,
                       remembered, regular, regular}};
  scene.memory_columns = {{4, 2, alpha}, {5, 3, alpha}};
  return scene;
}

}  // namespace

// Extremum of int 1/2 v^2 - u + g.q + mu f dt. The adjoint of a left Caputo derivative is the right
// Riemann-Liouville derivative, -d/dt J_-^(1-alpha), and vice versa. So with p = v + mu a
//   p' = -grad u + g - b rho' + c ell',
// and pi = p + b rho - c ell has an equation of order 1. The motion under the same constraint has no terms in
// mu', rho or ell. Across a the two differ by (e.c) ell - (e.b) rho, the column defect, which is 0 if b and c
// are parallel to a: this is Proposition 2.
SceneFactory fractional_vakonomic() {
  const std::vector<Parameter> parameters = concatenated(
      {weight_parameters(),
       prescribed_load_parameters(),
       drive_parameters(),
       {choice("ends", {"place", "momentum"}, "what is given across a at T: e.q, or e.(p - c ell)"),
        {"across", -0.2, any_number, "that, e = (-a2, a1)/|a|"},
        {"along", 0.0, any_number, "a.(p - c ell)/|a| at T: 0 where a.q(T) is free"}}});
  return {.id = "fractional_vakonomic",
          .title = "Conditional extremum under a constraint with left and right derivatives",
          .source = "Tarasov & Zaslavsky 2006, eqs 68-72 corrected",
          .parameters = parameters,
          .make = [](const Parameters& p) -> Scene {
            if (p["a1"] == 0.0 && p["a2"] == 0.0) reject("a1", 0.0, "other than 0 where a2 = 0");
            return scene_of({.a = {p["a1"], p["a2"]},
                             .b = {p["b1"], p["b2"]},
                             .c = {p["c1"], p["c2"]},
                             .stiffness = {p["k1"], p["k2"]}},
                            p);
          },
          .display_equations = {{"D(q, 1)", "p - mu*a"},
                                {"D(p, 1)", "g(t) - grad(u) - b*D(rho, 1) + c*D(ell, 1)"},
                                {"rho", "J_right(mu, 1 - alpha)"},
                                {"ell", "J(mu, 1 - alpha)"},
                                {"a*D(q, 1) + b*D(q, alpha) + c*D_right(q, alpha)", "F(t)"}}};
}

}  // namespace fde::bench
