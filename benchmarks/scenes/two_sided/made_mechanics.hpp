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

// The scene of a mechanical system with one constraint that is made from its motion. A system says its end,
// rhs(t, y, f), jacobian(y, result), columns(t, y, result), energy(columns), constraint(t, columns), exact()
// and smoothness().
template <class System>
Scene made_scene(const System& system, const std::vector<Component>& components,
                 const std::vector<std::string>& names, const std::vector<Memory>& memories) {
  return {.problem = {.components = components,
                      .rhs = [system](double t, In y, Out f) { system.rhs(t, y, f); },
                      .derivatives = DenseJacobian{[system](double, In y, OutMatrix result) {
                        system.jacobian(y, result);
                      }},
                      .end = System::end},
          .smoothness = system.smoothness(),
          .outputs = {names, [system](double t, In y, Out columns) { system.columns(t, y, columns); }},
          .reference = system.exact(),
          .energy = {.value = [system](In columns) { return system.energy(columns); }},
          .constraint = {.size = 1,
                         .value = [system](double t, In columns,
                                           Out f) { f[0] = system.constraint(t, columns); }},
          .memories = memories};
}

}  // namespace fde
