// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/two_sided/sum_of_powers.hpp"

namespace fde::bench {

using Plane = Eigen::Vector2d;

// The values of two sums of powers at t, as a point or a velocity.
inline Plane point_at(const std::array<SumOfPowers, 2>& sums, double t) {
  return {sums[0].at(t), sums[1].at(t)};
}

// The unit vector e perpendicular to a.
inline Plane perpendicular(const Plane& a) { return Plane(-a[1], a[0]) / a.norm(); }

constexpr double manufactured_end = 2.0;  // of manufactured solutions

// The powers with which a solution without further regularity starts, in rows of order 1 (`regular`) and of
// order 1 - alpha (`memory`).
struct TwoSidedStartExponents {
  explicit TwoSidedStartExponents(double alpha);

  std::vector<double> regular, memory;
};

// The concatenation of lists of parameters.
std::vector<Parameter> concatenated(const std::vector<std::vector<Parameter>>& groups);

// T, a constant force and q(0) of a problem that is not manufactured.
std::vector<Parameter> prescribed_load_parameters();
// The parameter `motion`: whether the solution is manufactured or follows from given loads and end values.
Parameter motion_choice();
bool has_prescribed_loads(const Parameters& p);
struct PrescribedLoads {
  explicit PrescribedLoads(const Parameters& p);

  double end;
  Plane force, start;  // start: q(0)
};

// The order and the weights of a constraint a.v + b.w + c.r = F(t), and the stiffnesses.
std::vector<Parameter> weight_parameters();

// The parameters of F(t) in a constraint a.v + b.w + c.r = F(t), and F itself.
std::vector<Parameter> drive_parameters();
std::function<double(double t)> constraint_drive(const Parameters& p);

// The scene of a mechanical system with one constraint, without smoothness and reference. A System has end,
// rhs(t, y, f), jacobian(y, result), columns(t, y, result), energy(columns) and constraint(t, columns).
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

}  // namespace fde::bench
