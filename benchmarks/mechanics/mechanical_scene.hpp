#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "above_order_one.hpp"
#include "below_order_one.hpp"
#include "formulation.hpp"
#include "posed.hpp"
#include "scene.hpp"
#include "whole_order.hpp"

namespace fde::mechanics {

// What a scene says of its mechanics. System::constant: f = a.v + b.w + c with constant a, b, c.
template <class System>
struct Setting {
  System system;
  Motion<System::coordinates> start;
  std::vector<std::string> coordinates;  // their names
  double end = 10.0;
  bool linear = false;                              // all equations are linear in q, v, w
  Formulation reference = Formulation::integrated;  // the form that a reference is computed of
};

// How the parameters ask for the equations.
struct Asked {
  Formulation formulation = Formulation::integrated;
  double kappa = 0.0;
};

inline Asked asked_of(const Parameters& parameters, const std::vector<Formulation>& fitting) {
  const Formulation formulation = formulation_of(parameters, fitting);
  return {formulation, formulation == Formulation::stabilised ? parameters["kappa"] : 0.0};
}

template <class System>
concept ConstantCoefficients = HasMemory<System> && System::constant;

// The equations of the setting in one form. Throws std::invalid_argument where that form is not well posed.
template <class System>
PosedMechanics posed(const Setting<System>& of, const Asked& asked) {
  const auto& [system, start, names, end, linear, reference] = of;
  const bool stabilised = asked.formulation == Formulation::stabilised;
  const bool accelerated = stabilised || asked.formulation == Formulation::acceleration;
  const bool multiplied = asked.formulation == Formulation::multiplier;
  const double kappa = stabilised ? asked.kappa : 0.0;
  if constexpr (HasMemory<System>) {
    if (system.order < 1.0) {
      const IntegratedBelowOne<System> integrated{system, start};
      if (multiplied) {
        return with_multipliers(pose(MultiplierBelowOne<System>{system, start}, end, false),
                                pose(integrated, end, linear));
      }
      if (!accelerated) return pose(integrated, end, linear);
      const AccelerationBelowOne<System> acceleration{system, start, kappa};
      if (!acceleration.posed()) reject_singular(system.order);
      return pose(acceleration, end, linear);
    }
    if constexpr (ConstantCoefficients<System>) {
      if (system.order > 1.0) {
        const IntegratedAboveOne<System> integrated{system, start};
        if (accelerated) reject_above_one(system.order);
        if (multiplied) {
          auto form = pose(MultiplierAboveOne<System>{system, start}, end, false);
          return integrated.posed()
                     ? with_multipliers_above_one(std::move(form), pose(integrated, end, linear))
                     : form;
        }
        if (!integrated.posed()) reject_unaligned(system.order);
        return pose(integrated, end, linear);
      }
    }
  }
  auto acceleration = pose(WholeAcceleration<System>{system, start, kappa}, end, linear);
  if (multiplied)
    return with_multipliers(pose(WholeMultiplier<System>{system, start}, end, false), acceleration);
  if (accelerated) return acceleration;
  return pose(WholeIntegrated<System>{system, start}, end, linear);
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
  constexpr int n = System::coordinates;
  using Point = Vector<double, n>;
  Energy energy;
  energy.value = [system](In columns) {
    return energy_at(system, Point(columns.head<n>()), Point(columns.segment<n>(n)));
  };
  if constexpr (!HasMemory<System>) {
    energy.power = [system](double t, In columns) {
      const Point q = columns.head<n>(), v = columns.segment<n>(n);
      const auto rates = constraint_rates<double>(system, t, q, v, v);
      const Reaction<double, System> reaction(system, q, rates);
      const Vector<double, System::constraints> lambda =
          reaction.multiplier(rates.slope * free_acceleration<double>(system, t, q, v) + rates.flow);
      double power = v.dot(rates.reaction.transpose() * lambda);
      if constexpr (HasForce<System>) power += v.dot(system.template force<double>(t, q, v));
      return power;
    };
  }
  return energy;
}

template <class System>
Constraint constraint_of(const System& system) {
  constexpr int n = System::coordinates;
  return {System::constraints, [system](double t, In columns, Out f) {
            const Vector<double, n> q = columns.head<n>(), v = columns.segment<n>(n), w = columns.tail<n>();
            f = constraint_value<double>(system, t, q, v, w);
          }};
}

// The scene of a setting, but for what is exactly known. Columns: coordinates, velocities and, with memory,
// w = D^order q.
template <class System>
Scene mechanical_scene(const Setting<System>& of, const Asked& asked) {
  constexpr int n = System::coordinates;
  Scene scene;
  auto form = posed(of, asked);
  const auto names = column_names(of.coordinates, HasMemory<System>);
  scene.problem = std::move(form.problem);
  scene.smoothness = std::move(form.smoothness);
  scene.outputs = {names, std::move(form.columns)};
  auto powers = scene.smoothness.powers;
  if (asked.formulation != of.reference) {
    auto reference = posed(of, {of.reference});
    powers = reference.smoothness.powers;  // the solution is the same
    scene.reference = {std::move(reference.problem), {names, std::move(reference.columns)}};
  }
  scene.energy = energy_of(of.system);
  scene.constraint = constraint_of(of.system);
  if constexpr (HasMemory<System>) {
    if (of.system.order != 1.0) {
      for (Eigen::Index i = 0; i < n; ++i)
        scene.memories.push_back({Eigen::Index{2} * n + i, n + i, of.system.order,
                                  powers_of_derivative(powers[static_cast<std::size_t>(i)])});
    }
  }
  return scene;
}

}  // namespace fde::mechanics
