// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/mechanics/formulations/acceleration.hpp"
#include "fdebench/benchmarks/mechanics/formulations/formulation.hpp"
#include "fdebench/benchmarks/mechanics/formulations/integrated.hpp"
#include "fdebench/benchmarks/mechanics/formulations/integrated_above_one.hpp"
#include "fdebench/benchmarks/mechanics/formulations/motion_powers.hpp"
#include "fdebench/benchmarks/mechanics/formulations/multiplier.hpp"
#include "fdebench/benchmarks/mechanics/formulations/posed.hpp"

namespace fde::bench::mechanics {

// The mechanics of a scene. System::constant: f = a.v + b.w + c with constant a, b, c.
template <class System>
struct MechanicalSetup {
  System system;
  InitialState<System::coordinates> start;
  std::vector<std::string> coordinates;  // their names
  double end = 10.0;
  Formulation reference = Formulation::integrated;  // the formulation used for a reference
};

template <class System>
concept ConstantCoefficients = HasMemory<System> && System::constant;

// How the reaction starts below order 1. At first v - v(0) is along the singular direction, and w is along
// v(0); the result depends on whether the direction of the reaction changes, not on the size of the change.
template <class System>
ReactionStart reaction_start(const System& system, const InitialState<System::coordinates>& start) {
  constexpr double rounding = 1e-12;
  constexpr int n = System::coordinates;
  const Vector<double, n> singular = singular_direction(system, start), moved = start.v + singular;
  if (singular.isZero(0.0)) return ReactionStart::regular;
  const auto before = linearize_constraints<double>(system, 0.0, start.q, start.v, zeros<double, n>()),
             after = linearize_constraints<double>(system, 0.0, start.q, moved, start.v);
  const Reaction<double, System> reaction(system, start.q, before);
  for (int i = 0; i < System::constraints; ++i) {
    const Vector<double, n> direction =
        raise_index<double>(system, start.q, Vector<double, n>(after.velocity_jacobian.row(i).transpose()));
    if (reaction.projected(direction).norm() > rounding * direction.norm())
      return ReactionStart::singular_with_varying_direction;
  }
  return ReactionStart::singular;
}

// The initial state after an immediate jump of v along the reaction. At order 1, where w = v, an initial v
// with f != 0 must jump. It is the limit from below: for order < 1, w(0) = 0, and as the order tends to 1, w
// approaches v ever faster.
template <class System>
InitialState<System::coordinates> consistent_initial_state(const System& system,
                                                           InitialState<System::coordinates> start) {
  if constexpr (HasMemory<System>) {
    const auto rates = linearize_constraints<double>(system, 0.0, start.q, start.v, start.v);
    start.v += Reaction<double, System>(system, start.q, rates).compensating_acceleration(rates.value);
  }
  return start;
}

// Order 1, or no memory.
template <class System>
MechanicalProblem posed_at_one(MechanicalSetup<System> of, const FormulationChoice& choice) {
  constexpr auto memory = MemoryRows::none;
  of.start = consistent_initial_state(of.system, of.start);
  if (choice.formulation == Formulation::integrated)
    return make_problem(Integrated<System, memory>{of.system, of.start}, of.end);
  auto acceleration =
      make_problem(AccelerationWithoutMemory<System>{of.system, of.start, choice.kappa}, of.end);
  if (choice.formulation != Formulation::multiplier) return acceleration;
  return with_multipliers(make_problem(Multiplier<System, memory>{of.system, of.start}, of.end),
                          acceleration.smoothness);
}

// 0 < order < 1.
template <class System>
MechanicalProblem posed_below_one(const MechanicalSetup<System>& of, const FormulationChoice& choice) {
  constexpr auto memory = MemoryRows::below_one;
  const double order = of.system.order;
  const ReactionStart reaction = reaction_start(of.system, of.start);
  const MotionExponents powers = powers_below_one(order, !of.start.v.isZero(0.0), reaction);
  auto integrated = make_problem(Integrated<System, memory>{of.system, of.start}, of.end);
  if constexpr (!Linear<System>) integrated.smoothness = integrated_start(powers, order, integrated.layout);
  if (choice.formulation == Formulation::integrated) return integrated;
  if (choice.formulation == Formulation::multiplier) {
    return with_multipliers(make_problem(Multiplier<System, memory>{of.system, of.start}, of.end),
                            integrated.smoothness);
  }
  const AccelerationBelowOne<System> acceleration{of.system, of.start, choice.kappa};
  if (!acceleration.is_well_posed()) return refused_as_singular(choice.formulation, order);
  auto form = make_problem(acceleration, of.end);
  if constexpr (!Linear<System>)
    form.smoothness = acceleration_start(powers, order, form.layout, reaction != ReactionStart::regular);
  exclude_from_measures(form.smoothness, form.layout.s);
  return form;
}

// 1 < order < 2.
template <ConstantCoefficients System>
MechanicalProblem posed_above_one(const MechanicalSetup<System>& of, const FormulationChoice& choice) {
  const double order = of.system.order;
  const bool multiplied = choice.formulation == Formulation::multiplier;
  if (!multiplied && choice.formulation != Formulation::integrated)
    return refused_above_one(choice.formulation, order);
  const IntegratedAboveOne<System> integrated{of.system, of.start};
  const auto with_rows = [&] {
    return make_problem(Multiplier<System, MemoryRows::above_one>{of.system, of.start}, of.end);
  };
  if (!integrated.is_well_posed()) {
    if (!multiplied) return refused_as_unaligned(order);
    return with_rows();
  }
  auto form = make_problem(integrated, of.end);
  if constexpr (!Linear<System>) {
    const MotionExponents powers = powers_above_one(order, !of.start.v.isZero(0.0));
    form.smoothness = integrated_start_above_one(powers, order, form.layout);
  }
  return multiplied ? with_multipliers_above_one(with_rows(), form) : form;
}

// The equations of the setting in one formulation, or the reason why it is not well posed.
template <class System>
MechanicalProblem pose_formulation(const MechanicalSetup<System>& of, const FormulationChoice& choice) {
  if constexpr (HasMemory<System>) {
    if (of.system.order < 1.0) return posed_below_one(of, choice);
  }
  if constexpr (ConstantCoefficients<System>) {
    if (of.system.order > 1.0) return posed_above_one(of, choice);
  }
  return posed_at_one(of, choice);
}

// Whether the formulation of the reference is well posed.
template <class System>
bool has_reference_form([[maybe_unused]] const MechanicalSetup<System>& of) {
  if constexpr (ConstantCoefficients<System>) {
    if (of.system.order > 1.0) return IntegratedAboveOne<System>{of.system, of.start}.is_well_posed();
  }
  return true;
}

}  // namespace fde::bench::mechanics
