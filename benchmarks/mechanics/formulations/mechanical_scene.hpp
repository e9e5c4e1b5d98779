// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "fdebench/benchmarks/mechanics/formulations/reactions.hpp"
#include "fdebench/benchmarks/mechanics/formulations/state_geometry.hpp"

namespace fde::bench::mechanics {

template <class System>
Constraint constraint_of(const System& system) {
  static constexpr Layout at = column_layout<System>();
  using Point = Vector<double, System::coordinates>;
  return {System::constraints, [system](double t, In columns, Out f) {
            const Point q = part<at.q>(columns), v = part<at.v>(columns), w = part<at.w>(columns);
            f = constraint_value<double>(system, t, q, v, w);
          }};
}

// The columns w as memory columns, with powers derived from those of the rows q, which are the same in all
// formulations.
template <class System>
std::vector<MemoryColumn> memories_of(const System& system, const std::vector<std::vector<double>>& powers,
                                      RowBlock q) {
  static constexpr Layout at = column_layout<System>();
  std::vector<MemoryColumn> memories;
  for (int i = 0; i < q.size; ++i)
    memories.push_back({at.w.first + i, at.v.first + i, system.order, powers_of_derivative(powers[q[i]])});
  return memories;
}

// The scene of a setting, without an exact reference. Columns: coordinates, velocities and, with memory, w =
// D^order q.
template <class System>
Scene mechanical_scene(const MechanicalSetup<System>& of, const FormulationChoice& choice) {
  Scene scene;
  auto form = pose_formulation(of, choice);
  const auto names = column_names(of.coordinates, HasMemory<System>);
  scene.ill_posed_reason = std::move(form.ill_posed_reason);
  scene.problem = std::move(form.problem);
  scene.smoothness = std::move(form.smoothness);
  scene.outputs = {names, std::move(form.columns)};
  auto powers = scene.smoothness.powers;
  if (choice.formulation != of.reference && has_reference_form(of)) {
    auto reference = pose_formulation(of, {of.reference});
    powers = reference.smoothness.powers;  // the solution is the same
    scene.reference_problem = {std::move(reference.problem), {names, std::move(reference.columns)}};
  }
  scene.energy = energy_of(of.system);
  scene.constraint = constraint_of(of.system);
  scene.geometry = geometry_of(of.system, of.coordinates, consistent_initial_state(of.system, of.start));
  std::vector<double> powers_of_w;
  if constexpr (HasMemory<System>) {
    if (has_memory_column(of.system)) {
      scene.memory_columns = memories_of(of.system, powers, form.layout.q);
      powers_of_w = powers_of_memory(powers, form.layout.q, of.system.order);
    }
  }
  scene.reactions = reactions_of(of.system, of.start, std::move(powers_of_w));
  return scene;
}

// Restricts a scene on a sphere, whose first column is the distance from a pole, to the domain between the
// poles.
inline void exclude_poles(Scene& scene) {
  const auto domain = [](const Outputs& outputs) -> Domain {
    return {"a pole, theta = 0 or pi", [outputs](double t, In y) {
              const double theta = columns_at(outputs, t, y)[0];
              return std::min(theta, std::numbers::pi - theta);
            }};
  };
  scene.problem.domain = domain(scene.outputs);
  if (scene.reference_problem)
    scene.reference_problem->problem.domain = domain(scene.reference_problem->outputs);
}

// The position on the unit sphere, for a scene whose columns start with theta (distance from a pole) and phi
// (longitude).
inline Outputs path_on_sphere() {
  return {{"x", "y", "z"}, [](double /*t*/, In columns, Out place) {
            const double theta = columns[0], phi = columns[1];
            place << std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta);
          }};
}

}  // namespace fde::bench::mechanics
