#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "above_order_one.hpp"
#include "below_order_one.hpp"
#include "formulation.hpp"
#include "posed.hpp"
#include "scene.hpp"
#include "start_powers.hpp"
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
  std::string no_reference{};                       // why there is none, where there is none
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

template <class System>
ReactionStart reaction_start(const System& system, const Motion<System::coordinates>& start) {
  if (singular_direction(system, start).isZero(0.0)) return ReactionStart::regular;
  const Vector<double, System::coordinates> none = Vector<double, System::coordinates>::Zero();
  const auto before = constraint_rates<double>(system, 0.0, start.q, start.v, none),
             after = constraint_rates<double>(system, 0.0, start.q, start.v, start.v);  // w is along v(0)
  return before.reaction == after.reaction ? ReactionStart::singular : ReactionStart::singular_and_turning;
}

// 0 < order < 1.
template <class System>
PosedMechanics posed_below_one(const Setting<System>& of, Formulation formulation, double kappa) {
  constexpr int n = System::coordinates;
  const auto& [system, start, names, end, linear, reference, unknown] = of;
  const ReactionStart reaction = reaction_start(system, start);
  const MotionPowers powers = powers_below_one(system.order, !start.v.isZero(0.0), reaction);
  const IntegratedBelowOne<System> integrated{system, start};
  const Smoothness starts =
      linear ? pose(integrated, end, true).smoothness : integrated_start(powers, system.order, n);
  if (formulation == Formulation::multiplier)
    return with_multipliers(pose(MultiplierBelowOne<System>{system, start}, end, false), starts);
  if (formulation == Formulation::integrated) {
    auto form = pose(integrated, end, linear);
    form.smoothness = starts;
    return form;
  }
  const AccelerationBelowOne<System> acceleration{system, start, kappa};
  if (!acceleration.posed()) reject_singular(system.order);
  auto form = pose(acceleration, end, linear);
  if (!linear)
    form.smoothness = acceleration_start(powers, system.order, n, reaction != ReactionStart::regular);
  for (int i = 2 * n; i < 3 * n; ++i) form.smoothness.hidden.push_back(i);  // D^alpha v
  return form;
}

// 1 < order < 2.
template <ConstantCoefficients System>
PosedMechanics posed_above_one(const Setting<System>& of, Formulation formulation) {
  constexpr int n = System::coordinates;
  const auto& [system, start, names, end, linear, reference, unknown] = of;
  const IntegratedAboveOne<System> integrated{system, start};
  if (formulation != Formulation::integrated && formulation != Formulation::multiplier)
    reject_above_one(system.order);
  const bool multiplied = formulation == Formulation::multiplier;
  if (!integrated.posed()) {
    if (!multiplied) reject_unaligned(system.order);
    return pose(MultiplierAboveOne<System>{system, start}, end, false);
  }
  auto form = pose(integrated, end, linear);
  if (!linear) {
    form.smoothness =
        integrated_start_above_one(powers_above_one(system.order, !start.v.isZero(0.0)), system.order, n);
  }
  if (!multiplied) return form;
  return with_multipliers_above_one(pose(MultiplierAboveOne<System>{system, start}, end, false),
                                    form.smoothness);
}

// The equations of the setting in one form. Throws std::invalid_argument where that form is not well posed.
template <class System>
PosedMechanics posed(const Setting<System>& of, const Asked& asked) {
  const auto& [system, start, names, end, linear, reference, unknown] = of;
  const bool stabilised = asked.formulation == Formulation::stabilised;
  const bool accelerated = stabilised || asked.formulation == Formulation::acceleration;
  const bool multiplied = asked.formulation == Formulation::multiplier;
  const double kappa = stabilised ? asked.kappa : 0.0;
  if constexpr (HasMemory<System>) {
    if (system.order < 1.0) return posed_below_one(of, asked.formulation, kappa);
    if constexpr (ConstantCoefficients<System>) {
      if (system.order > 1.0) return posed_above_one(of, asked.formulation);
    }
  }
  auto acceleration = pose(WholeAcceleration<System>{system, start, kappa}, end, linear);
  if (multiplied)
    return with_multipliers(pose(WholeMultiplier<System>{system, start}, end, false),
                            acceleration.smoothness);
  if (accelerated) return acceleration;
  return pose(WholeIntegrated<System>{system, start}, end, linear);
}

// Whether the form of the reference is well posed.
template <class System>
bool has_reference_form([[maybe_unused]] const Setting<System>& of) {
  if constexpr (ConstantCoefficients<System>) {
    if (of.system.order > 1.0) return IntegratedAboveOne<System>{of.system, of.start}.posed();
  }
  return true;
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
  scene.no_reference = of.no_reference;
  auto powers = scene.smoothness.powers;
  if (of.no_reference.empty() && asked.formulation != of.reference && has_reference_form(of)) {
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
