// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"

namespace fde::bench {
namespace {

using namespace mechanics;

// A blade on an inclined plane, x down the slope: u = -g sin(theta) x. With n = (sin phi, -cos phi), the
// direction across the blade, the constraint is n.v + b n.D^alpha (x, y) = 0. Mass and moment of inertia are
// 1.
struct BladeOnPlane {
  static constexpr int coordinates = 3, constraints = 1;
  double order, b, pull;

  template <class S>
  [[nodiscard]] S potential(const Vector<S, 3>& q) const {
    return -pull * q[0];
  }
  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 3>& q, const Vector<S, 3>& v,
                                        const Vector<S, 3>& w) const {
    using std::cos, std::sin;
    const S across = sin(q[2]), along = cos(q[2]);
    return Vector<S, 1>(S(across * (v[0] + b * w[0]) - along * (v[1] + b * w[1])));
  }
};

// A point on the unit sphere, theta from the top: u = g cos(theta). The constraint is sin(theta) phi' - k
// theta' + b (sin(theta) D^alpha phi - k D^alpha theta) = 0.
struct BladeOnSphere {
  static constexpr int coordinates = 2, constraints = 1;
  double order, b, k, gravity;

  template <class S>
  [[nodiscard]] S potential(const Vector<S, 2>& q) const {
    using std::cos;
    return gravity * cos(q[0]);
  }
  template <class S>
  [[nodiscard]] Diagonal<S, 2> metric(const Vector<S, 2>& q) const {
    using std::sin;
    const S radius = sin(q[0]);
    return Diagonal<S, 2>({S(1.0), radius * radius});
  }
  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 2>& q, const Vector<S, 2>& v,
                                        const Vector<S, 2>& w) const {
    using std::sin;
    return Vector<S, 1>(S(sin(q[0]) * (v[1] + b * w[1]) - k * (v[0] + b * w[0])));
  }
};

MechanicalSetup<BladeOnPlane> on_plane(const Parameters& p) {
  return {.system = {p["alpha"], p["b"], p["g"] * std::sin(p["theta"])},
          .start = {{0.0, 0.0, 0.0}, {p["speed"], 0.0, p["omega"]}},
          .coordinates = {"x", "y", "phi"},
          .end = 10.0};
}

MechanicalSetup<BladeOnSphere> on_sphere(const Parameters& p) {
  const double theta = p["theta0"], down = p["speed"] / std::hypot(1.0, p["k"]);
  return {.system = {p["alpha"], p["b"], p["k"], p["g"]},
          .start = {{theta, 0.0}, {down, p["k"] * down / std::sin(theta)}},
          .coordinates = {"theta", "phi"},
          .end = 2.0};
}

}  // namespace

// The constraint a(q).v + b a(q).D^alpha q = 0 on a plane and on a sphere. For alpha = 1 it is 1 + b times
// the constraint without memory: the scenes knife_edge and, with g = 0, loxodrome. The initial state
// satisfies the constraint, so no term is singular.
SceneFactory fractional_knife_edge() {
  constexpr Range between_the_poles{
      .low = 0.0, .high = std::numbers::pi, .open_low = true, .open_high = true};
  const std::vector<Parameter> parameters{choice("surface", {"plane", "sphere"}, "what the blade is on"),
                                          {"alpha", 0.6, order_up_to_one, "order of the constraint"},
                                          {"b", 0.5, any_number, "weight of the memory"},
                                          {"speed", 0.5, any_number, "at t = 0, along the blade"},
                                          {"g", 1.0, any_number, "gravity"},
                                          {"theta", 0.5, any_number, "inclination (plane)"},
                                          {"omega", 1.0, any_number, "turns per 2 pi of time (plane)"},
                                          {"k", 0.5, any_number, "slope of the course (sphere)"},
                                          {"theta0", 0.7, between_the_poles, "theta(0) (sphere)"}};
  return {.id = "fractional_knife_edge",
          .title = "Knife edge with memory on an inclined plane or a sphere",
          .source = "Tarasov & Zaslavsky 2006, eqs 32, 36, 38; Niminet & Blanuta 2009, eq. 2.6 (corrected)",
          .parameters = with_formulations(parameters, all_formulations()),
          .make = [](const Parameters& p) -> Scene {
            if (p["alpha"] == 1.0 && p["b"] == -1.0) reject("b", -1.0, "other than -1 for alpha = 1");
            const FormulationChoice asked = formulation_choice_of(p);
            if (p.choice("surface") == "plane") {
              Scene scene = mechanical_scene(on_plane(p), asked);
              scene.display_path = select_components({"x", "y"}, {0, 1});
              return scene;
            }
            Scene scene = mechanical_scene(on_sphere(p), asked);
            exclude_poles(scene);
            scene.display_path = path_on_sphere();
            return scene;
          },
          .display_equations = {{"d_over_dt*dL_over_dv - dL_over_dq", "lambda*a(q)"},
                                {"a(q)*(D(q, 1) + b*D(q, alpha))", "0"}}};
}

}  // namespace fde::bench
