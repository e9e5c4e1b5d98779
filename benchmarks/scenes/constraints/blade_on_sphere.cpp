// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"
#include "fdebench/benchmarks/scenes/constraints/classical_systems.hpp"

namespace fde::bench {
namespace {

using namespace mechanics;

// A blade of mass 1 and moment of inertia I on the unit sphere: theta is the distance from the pole, phi the
// longitude, psi the heading, measured from the meridian. It turns about the normal at the rate psi' + phi'
// cos theta and must not slide sideways. u = gravity cos theta. The coordinates are singular at the poles.
struct BladeOnSphere {
  static constexpr int coordinates = 3, constraints = 1;
  double inertia, gravity;

  template <class S>
  [[nodiscard]] Table<S, 3, 3> metric(const Vector<S, 3>& q) const {
    using std::cos;
    const S sine = ConstantCourseOnSphere::sine<S>(q[0]), cosine = cos(q[0]);
    auto g = zeros<S, 3, 3>();
    g(0, 0) = S(1.0);
    g(1, 1) = sine * sine + inertia * cosine * cosine;
    g(1, 2) = g(2, 1) = inertia * cosine;
    g(2, 2) = S(inertia);
    return g;
  }
  template <class S>
  [[nodiscard]] S potential(const Vector<S, 3>& q) const {
    using std::cos;
    return gravity * cos(q[0]);
  }
  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 3>& q, const Vector<S, 3>& v) const {
    using std::cos, std::sin;
    return Vector<S, 1>(S(v[0] * sin(q[2]) - v[1] * ConstantCourseOnSphere::sine<S>(q[0]) * cos(q[2])));
  }
};

}  // namespace

// Three coordinates, a curved metric with an off-diagonal entry, and a nonholonomic constraint. The energy
// and the rate of turning are conserved; without gravity also the speed, and the blade traces a circle whose
// geodesic curvature is rate of turning / speed.
SceneFactory blade_on_sphere() {
  const std::vector<Parameter> parameters{
      {"theta0",
       1.2,
       {.low = 0.0, .high = std::numbers::pi, .open_low = true, .open_high = true},
       "theta(0), distance from the pole"},
      {"psi0", 0.5, any_number, "psi(0), heading from the meridian"},
      {"speed", 0.6, any_number, "speed along the blade at 0"},
      {"spin", 1.0, any_number, "rate of turning about the normal"},
      {"inertia", 0.4, positive, "moment of inertia about the normal"},
      {"gravity", 0.2, any_number, "of the potential gravity cos(theta)"}};
  return {
      .id = "blade_on_sphere",
      .title = "Blade on a sphere",
      .source = "Niminet & Blanuta 2009, eqs 1.1-2.9 without the factor 1/2 of 2.6",
      .parameters = with_formulations(parameters, all_formulations()),
      .make = [](const Parameters& p) -> Scene {
        const double theta = p["theta0"], psi = p["psi0"], speed = p["speed"];
        const double dphi = speed * std::sin(psi) / std::sin(theta);
        const MechanicalSetup<BladeOnSphere> setting{
            .system = {.inertia = p["inertia"], .gravity = p["gravity"]},
            .start = {{theta, 0.0, psi}, {speed * std::cos(psi), dphi, p["spin"] - dphi * std::cos(theta)}},
            .coordinates = {"theta", "phi", "psi"}};
        Scene scene = mechanical_scene(setting, formulation_choice_of(p));
        exclude_poles(scene);
        scene.display_path = path_on_sphere();
        return scene;
      },
      .equations = {
          {.unknown = "theta",
           .terms = {{"1", "2"}},
           .rhs = "sin(theta)*cos(theta)*D(phi,1)^2 - inertia*spin*sin(theta)*D(phi,1) + gravity*sin(theta) "
                  "+ lambda*sin(psi)",
           .initial = {"theta0", "speed*cos(psi0)"}},
          {.unknown = "phi",
           .terms = {{"1", "2"}},
           .rhs = "(inertia*spin*D(theta,1) - lambda*cos(psi))/sin(theta) - "
                  "2*cos(theta)/sin(theta)*D(theta,1)*D(phi,1)",
           .initial = {"0", "speed*sin(psi0)/sin(theta0)"}},
          {.unknown = "psi", .terms = {{"1", "1"}}, .rhs = "spin - D(phi,1)*cos(theta)", .initial = {"psi0"}},
          {.unknown = "lambda",
           .terms = {{"1", "0"}},
           .rhs = "D(theta,1)*sin(psi) - sin(theta)*D(phi,1)*cos(psi)",
           .initial = {"0"}}}};
}

}  // namespace fde::bench
