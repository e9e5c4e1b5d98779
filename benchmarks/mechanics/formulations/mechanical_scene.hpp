#pragma once

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "mechanics/formulations/setting.hpp"
#include "mechanics/formulations/state_geometry.hpp"
#include "scenes/scene.hpp"

namespace fde::mechanics {

// Which columns of a scene are what: q, v and, with memory, w = D^order q, which otherwise is v.
template <class System>
constexpr Layout column_layout() {
  constexpr int n = System::coordinates;
  return {.q = {0, n}, .v = {n, n}, .w = {HasMemory<System> ? 2 * n : n, n}};
}

// 1/2 v'G v + u.
template <class System>
double energy_at([[maybe_unused]] const System& system, const Vector<double, System::coordinates>& q,
                 const Vector<double, System::coordinates>& v) {
  double value = 0.0;
  if constexpr (HasMetric<System>) {
    value = 0.5 * v.dot(system.template metric<double>(q) * v);
  } else {
    value = 0.5 * v.squaredNorm();
  }
  if constexpr (HasPotential<System>) value += system.template potential<double>(q);
  return value;
}

// E = 1/2 v'G v + u. Its rate is the power of forces and reactions; with memory the reaction depends on w',
// which is no column, and the rate stays unsaid.
template <class System>
Energy energy_of(const System& system) {
  static constexpr Layout at = column_layout<System>();
  using Point = Vector<double, System::coordinates>;
  Energy energy;
  energy.value = [system](In columns) {
    return energy_at(system, Point(part<at.q>(columns)), Point(part<at.v>(columns)));
  };
  if constexpr (!HasMemory<System>) {
    energy.power = [system](double t, In columns) {
      const Point q = part<at.q>(columns), v = part<at.v>(columns);
      const auto rates = constraint_rates<double>(system, t, q, v, v);
      const auto lambda = enforcing_multiplier<double>(system, t, q, v, rates);
      double power = v.dot(rates.reaction.transpose() * lambda);
      if constexpr (HasForce<System>) power += v.dot(system.template force<double>(t, q, v));
      return power;
    };
  }
  return energy;
}

template <class System>
Constraint constraint_of(const System& system) {
  static constexpr Layout at = column_layout<System>();
  using Point = Vector<double, System::coordinates>;
  return {System::constraints, [system](double t, In columns, Out f) {
            const Point q = part<at.q>(columns), v = part<at.v>(columns), w = part<at.w>(columns);
            f = constraint_value<double>(system, t, q, v, w);
          }};
}

// The scene of a setting, but for what is exactly known. Columns: coordinates, velocities and, with memory,
// w = D^order q.
template <class System>
Scene mechanical_scene(const Setting<System>& of, const Asked& asked) {
  Scene scene;
  auto form = posed(of, asked);
  const auto names = column_names(of.coordinates, HasMemory<System>);
  scene.problem = std::move(form.problem);
  scene.smoothness = std::move(form.smoothness);
  scene.outputs = {names, std::move(form.columns)};
  scene.no_reference = of.no_reference;
  auto powers = scene.smoothness.powers;
  if (of.no_reference.empty() && asked.formulation != of.reference && has_reference_form(of)) {
    auto reference = posed(of, {of.reference});
    powers = reference.smoothness.powers;  // the solution is the same
    scene.reference_problem = {std::move(reference.problem), {names, std::move(reference.columns)}};
  }
  scene.energy = energy_of(of.system);
  scene.constraint = constraint_of(of.system);
  scene.geometry = geometry_of(of.system, of.coordinates);
  if constexpr (HasMemory<System>) {
    if (of.system.order != 1.0) {
      static constexpr Layout at = column_layout<System>();
      const Group q = form.layout.q;  // the same rows in all formulations
      for (int i = 0; i < q.size; ++i) {
        scene.memories.push_back(
            {at.w.first + i, at.v.first + i, of.system.order, powers_of_derivative(powers[q[i]])});
      }
    }
  }
  return scene;
}

// For a scene on a sphere, whose first column is the distance from a pole: its coordinates end at both.
inline void end_at_the_poles(Scene& scene) {
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

}  // namespace fde::mechanics
