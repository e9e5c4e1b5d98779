// SPDX-License-Identifier: MIT
#include <array>

#include "fdebench/benchmarks/scenes/two_sided/plane_mechanics.hpp"

namespace fde::bench {
namespace {

// The manufactured solution: q, q', q'', and w and r, its left and right derivatives of order alpha. With q1
// = 1 + 3 t^2 - t^3 and q2 = t^2 (2 - t)^2 both velocities are 0 at both ends.
struct ConstrainedMotion {
  explicit ConstrainedMotion(double alpha)
      : q{SumOfPowers::polynomial({1.0, 0.0, 3.0, -1.0}),
          SumOfPowers::polynomial({0.0, 0.0, 4.0, -4.0, 1.0})} {
    for (std::size_t i = 0; i < 2; ++i) {
      v[i] = q[i].derivative(1.0);
      acceleration[i] = q[i].derivative(2.0);
      w[i] = q[i].derivative(alpha);
      r[i] = q[i].reversed(manufactured_end).derivative(alpha);
    }
  }

  std::array<SumOfPowers, 2> q, v, acceleration, w, r;
};

// u = (k1 q1^2 + k2 q2^2)/2 + k3 q1^4/4; f = a.v + b.w + c.r - F(t) with w = D^alpha q and r = tD_T^alpha q.
// Components q1, q2, z, w1, w2, r1, r2, where z = e.v with e perpendicular to a: z' = e.v' does not contain
// the reaction, which is along a, and f = 0 determines the component of v along a.
struct TwoSidedConstraint {
  enum : Eigen::Index { q = 0, z = 2, w = 3, r = 5, size = 7 };
  Plane a, b, c;
  double k1, k2, k3;
  double end = manufactured_end;
  std::function<double(double t)> drive{};  // F
  std::function<Plane(double t)> force{};   // in addition to -grad u

  [[nodiscard]] Plane slope(const Plane& x) const { return {k1 * x[0] + k3 * x[0] * x[0] * x[0], k2 * x[1]}; }
  [[nodiscard]] double energy(In columns) const {
    const double x = columns[0], y = columns[1];
    return columns.segment<2>(2).squaredNorm() / 2 + (k1 * x * x + k2 * y * y) / 2 + k3 * x * x * x * x / 4;
  }

  [[nodiscard]] double residual(double t, const Plane& v, const Plane& left, const Plane& right) const {
    return a.dot(v) + b.dot(left) + c.dot(right) - drive(t);
  }
  [[nodiscard]] Plane velocity(double t, In y) const {
    const Plane free = perpendicular(a) * y[z];
    return free - a * (residual(t, free, y.segment<2>(w), y.segment<2>(r)) / a.squaredNorm());
  }

  void columns(double t, In y, Out result) const { result << y.head<2>(), velocity(t, y), y.tail<4>(); }
  [[nodiscard]] double constraint(double t, In columns) const {
    return residual(t, columns.segment<2>(2), columns.segment<2>(4), columns.segment<2>(6));
  }

  void rhs(double t, In y, Out f) const {
    const Plane v = velocity(t, y);
    f.segment<2>(q) = v;
    f[z] = perpendicular(a).dot(force(t) - slope(y.segment<2>(q)));
    f.segment<2>(w) = v;
    f.segment<2>(r) = -v;
  }

  void jacobian(In y, OutMatrix result) const {
    const Plane along = a / a.squaredNorm();
    Eigen::Matrix<double, 2, size> velocities = Eigen::Matrix<double, 2, size>::Zero();
    velocities.col(z) = perpendicular(a);
    velocities.middleCols<2>(w) = -along * b.transpose();
    velocities.middleCols<2>(r) = -along * c.transpose();
    result.setZero();
    result.middleRows<2>(q) = velocities;
    result(z, q) = -perpendicular(a)[0] * (k1 + 3.0 * k3 * y[q] * y[q]);
    result(z, q + 1) = -perpendicular(a)[1] * k2;
    result.middleRows<2>(w) = velocities;
    result.middleRows<2>(r) = -velocities;
  }
};

const std::vector<std::string> constraint_columns{"q1", "q2", "v1", "v2", "w1", "w2", "r1", "r2"};

std::vector<Component> components(double alpha, const Plane& start, const std::vector<double>& across) {
  const double memory = 1.0 - alpha;
  return {{1.0, {start[0]}},
          {1.0, {start[1]}},
          {1.0, across},
          {memory, {0.0}},
          {memory, {0.0}},
          {memory, {0.0}, Side::right},
          {memory, {0.0}, Side::right}};
}

std::vector<MemoryColumn> memories(double alpha) { return {{4, 2, alpha}, {5, 3, alpha}}; }

// F and a force are chosen so that the motion is the solution.
Scene manufactured_scene(TwoSidedConstraint system, double alpha) {
  const ConstrainedMotion motion(alpha);
  system.drive = [=, a = system.a, b = system.b, c = system.c](double t) {
    return a.dot(point_at(motion.v, t)) + b.dot(point_at(motion.w, t)) +
           c.dot(point_at(motion.r, manufactured_end - t));
  };
  system.force = [=](double t) -> Plane {
    return point_at(motion.acceleration, t) + system.slope(point_at(motion.q, t));
  };
  std::vector<ManufacturedColumn> known;
  for (const auto* sums : {&motion.q, &motion.v, &motion.w}) {
    for (const auto& sum : *sums) known.push_back({sum});
  }
  for (const auto& sum : motion.r) known.push_back({sum, Side::right});
  const auto free = perpendicular(system.a)[0] * motion.v[0] + perpendicular(system.a)[1] * motion.v[1];
  Scene scene =
      two_sided_scene(system, components(alpha, point_at(motion.q, 0.0), {0.0}), constraint_columns);
  scene.smoothness = {{motion.q[0].powers(), motion.q[1].powers(), free.powers(), motion.w[0].powers(),
                       motion.w[1].powers(), motion.r[0].powers(), motion.r[1].powers()}};
  scene.memory_columns = memories(alpha);
  scene.reference = manufactured_reference(known, manufactured_end);
  return scene;
}

// The velocity along a starts with the powers of w, which starts like t^(1-alpha). Right rows do the same at
// the end.
Smoothness smoothness_of_given(double alpha) {
  const auto [regular, remembered] = TwoSidedStartExponents(alpha);
  return {{regular, regular, regular, remembered, remembered, remembered, remembered}};
}

// The problem with q(0) given and, across a, either the velocity at 0 or the position at the end.
Scene prescribed_scene(TwoSidedConstraint system, double alpha, const Parameters& p) {
  const PrescribedLoads loads(p);
  const bool place = p.choice("ends") == "place";
  system.end = loads.end;
  system.drive = constraint_drive(p);
  system.force = [loads](double) { return loads.force; };
  const auto known = place ? std::vector<double>{} : std::vector<double>{p["across"]};
  Scene scene = two_sided_scene(system, components(alpha, loads.start, known), constraint_columns);
  if (place) {
    scene.problem.conditions = [e = perpendicular(system.a), at = p["across"]](In, In at_end, Out residual) {
      residual[0] = e.dot(at_end.head<2>()) - at;
    };
  }
  scene.smoothness = smoothness_of_given(alpha);
  scene.memory_columns = memories(alpha);
  return scene;
}

}  // namespace

// A mass in the plane on springs. r = -J_-^(1-alpha) q' depends on q' at later times, so the problem is
// two-sided.
SceneFactory two_sided_constraint() {
  return {.id = "two_sided_constraint",
          .title = "Oscillator in the plane with left and right derivatives in its constraint",
          .source = "Tarasov & Zaslavsky 2006, eqs 29, 38-41; manufactured, or with given loads and ends",
          .parameters = concatenated(
              {weight_parameters(),
               {{"k3", 0.5, any_number, "cubic stiffness of q1"}},
               {motion_choice()},
               prescribed_load_parameters(),
               drive_parameters(),
               {choice("ends", {"velocity", "place"}, "what is given across a: e.q'(0) or e.q(T)"),
                {"across", 0.3, any_number, "e.q'(0) or e.q(T), e = (-a2, a1)/|a|"}}}),
          .make = [](const Parameters& p) -> Scene {
            if (p["a1"] == 0.0 && p["a2"] == 0.0) reject("a1", 0.0, "other than 0 where a2 = 0");
            const TwoSidedConstraint system{.a = {p["a1"], p["a2"]},
                                            .b = {p["b1"], p["b2"]},
                                            .c = {p["c1"], p["c2"]},
                                            .k1 = p["k1"],
                                            .k2 = p["k2"],
                                            .k3 = p["k3"]};
            return has_prescribed_loads(p) ? prescribed_scene(system, p["alpha"], p)
                                           : manufactured_scene(system, p["alpha"]);
          },
          .display_equations = {{"D(q, 2)", "g(t) - grad(u) + mu*a"},
                                {"a*D(q, 1) + b*D(q, alpha) + c*D_right(q, alpha)", "F(t)"}}};
}

}  // namespace fde::bench
