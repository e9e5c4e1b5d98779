// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"
#include "fdebench/benchmarks/scenes/constraints/classical_systems.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"

namespace fde::bench {
namespace {

using namespace mechanics;

double time_to_pole(double theta0, double k, double speed) {
  return (std::numbers::pi - theta0) * std::hypot(1.0, k) / speed;
}

// At constant speed V: theta = theta0 + V t / sqrt(1 + k^2), phi = k ln(tan(theta/2) / tan(theta0/2)). The
// quotient is 1 + sin(delta) / (cos(theta/2) sin(theta0/2)) with delta = (theta - theta0)/2.
struct Loxodrome {
  double theta0, k, speed;

  template <class Real>
  [[nodiscard]] std::vector<reference::ConditionedValue<Real>> operator()(const Real& t) const {
    using std::abs, std::cos, std::log1p, std::sin, std::sqrt, std::tan;
    const Real start = reference::from_shortest_decimal<Real>(theta0),
               course = reference::from_shortest_decimal<Real>(k);
    const Real rate = reference::from_shortest_decimal<Real>(speed) / sqrt(Real(1 + course * course));
    const Real theta = start + rate * t, delta = rate * t / 2;
    if (theta >= reference::pi<Real>()) {
      throw std::runtime_error(
          fmt::format("the motion ends in the pole at t = {:.6g}", time_to_pole(theta0, k, speed)));
    }
    const Real phi = course * log1p(Real(sin(delta) / (cos(Real(theta / 2)) * sin(Real(start / 2)))));
    // d ln tan(theta/2) = d theta / sin theta: the effect of rounding theta at either end.
    const Real ends = theta / sin(theta) + start / sin(start), turn = abs(course) * rate / sin(theta);
    return {{theta, theta},
            {phi, Real(4 * abs(phi) + abs(course) * ends)},
            {rate, Real(2 * rate)},
            {Real(course * rate / sin(theta)), Real(turn * (3 + abs(Real(theta / tan(theta)))))}};
  }
};

}  // namespace

// Niminet & Blanuta's case: a Riemannian metric with Christoffel symbols and a constraint linear in the
// velocity.
SceneFactory loxodrome() {
  const std::vector<Parameter> parameters{
      {"theta0",
       0.5,
       {.low = 0.0, .high = std::numbers::pi, .open_low = true, .open_high = true},
       "theta(0), distance from the pole"},
      {"k", 2.0, any_number, "tangent of the angle to the meridians"},
      {"speed", 0.1, positive, "speed on the sphere"}};
  return {.id = "loxodrome",
          .title = "Point that keeps its course on a sphere",
          .source = "Niminet & Blanuta 2009, eq. 2.6 without the factor 1/2, on the unit sphere",
          .parameters = with_formulations(parameters, all_formulations()),
          .make = [](const Parameters& p) -> Scene {
            const double theta0 = p["theta0"], k = p["k"], rate = p["speed"] / std::hypot(1.0, k);
            // The end is before the pole, around which the curve winds infinitely often.
            const MechanicalSetup<ConstantCourseOnSphere> setting{
                .system = {k},
                .start = {{theta0, 0.0}, {rate, k * rate / std::sin(theta0)}},
                .coordinates = {"theta", "phi"},
                .end = std::min(50.0, 0.9 * time_to_pole(theta0, k, p["speed"]))};
            Scene scene = mechanical_scene(setting, formulation_choice_of(p));
            exclude_poles(scene);
            scene.reference = reference::closed_form(Loxodrome{theta0, k, p["speed"]});
            scene.display_path = path_on_sphere();
            return scene;
          },
          .equations = {{.unknown = "theta",
                         .terms = {{"1", "2"}},
                         .rhs = "sin(theta)*cos(theta)*D(phi,1)^2 - k*lambda",
                         .initial = {"theta0", "speed/sqrt(1 + k^2)"}},
                        {.unknown = "phi",
                         .terms = {{"1", "2"}},
                         .rhs = "-2*cos(theta)/sin(theta)*D(theta,1)*D(phi,1) + lambda/sin(theta)",
                         .initial = {"0", "k*speed/sqrt(1 + k^2)/sin(theta0)"}},
                        {.unknown = "lambda",
                         .terms = {{"1", "0"}},
                         .rhs = "sin(theta)*D(phi,1) - k*D(theta,1)",
                         .initial = {"0"}}}};
}

}  // namespace fde::bench
