#pragma once

#include <array>
#include <string>
#include <vector>

#include "scenes/two_sided/sum_of_powers.hpp"

namespace fde {

using Plane = Eigen::Vector2d;

// The values of two sums of powers: a point, a velocity, ...
inline Plane plane_at(const std::array<SumOfPowers, 2>& sums, double t) {
  return {sums[0].at(t), sums[1].at(t)};
}

// The unit vector across a.
inline Plane across(const Plane& a) { return Plane(-a[1], a[0]) / a.norm(); }

constexpr double end_of_motion = 2.0;  // of made ones

// The powers with which a motion that nothing makes smoother starts, in rows of order 1 and of order 1 -
// alpha.
struct GivenPowers {
  explicit GivenPowers(double alpha);

  std::vector<double> regular, remembered;
};

// One list after the other.
std::vector<Parameter> joined(const std::vector<std::vector<Parameter>>& groups);

// T, a constant force and q(0) of a problem whose motion is not made.
std::vector<Parameter> given_parameters();
// Whether the motion is made or what such parameters lead to.
Parameter motion_choice();
bool motion_is_given(const Parameters& p);
struct GivenLoads {
  explicit GivenLoads(const Parameters& p);

  double end;
  Plane force, start;  // start: q(0)
};

// The order and the weights of a constraint a.v + b.w + c.r = F(t), stiffnesses.
std::vector<Parameter> weight_parameters();

// F(t) of a constraint a.v + b.w + c.r = F(t).
std::vector<Parameter> drive_parameters();
std::function<double(double t)> given_drive(const Parameters& p);

// The scene of a mechanical system with one constraint, but for what is known of its motion. A system says
// its end, rhs(t, y, f), jacobian(y, result), columns(t, y, result), energy(columns) and constraint(t,
// columns).
template <class System>
Scene two_sided_scene(const System& system, const std::vector<Component>& components,
                      const std::vector<std::string>& names) {
  return {.problem = {.components = components,
                      .rhs = [system](double t, In y, Out f) { system.rhs(t, y, f); },
                      .derivatives = DenseJacobian{[system](double, In y, OutMatrix result) {
                        system.jacobian(y, result);
                      }},
                      .end = system.end},
          .outputs = {names, [system](double t, In y, Out columns) { system.columns(t, y, columns); }},
          .energy = {.value = [system](In columns) { return system.energy(columns); }},
          .constraint = {.size = 1, .value = [system](double t, In columns, Out f) {
                           f[0] = system.constraint(t, columns);
                         }}};
}

}  // namespace fde
