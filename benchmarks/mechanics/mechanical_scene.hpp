// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/mechanics/mechanical_system.hpp"
#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench::mechanics {

// The scene of a mechanical system in one formulation, up to `end`, without an exact reference. The columns
// are q, v and w with the given names. The energy is v.dL/dv - L if L does not depend on t; the geometry is
// that of a metric without velocities. Throws std::invalid_argument, and ConstraintError for a constraint, if
// the system has no regular motion from its start, or the formulation does not exist.
Scene mechanical_scene(const MechanicalSystem& system, const FormulationChoice& choice,
                       const std::vector<std::string>& names, double end, ExpressionPool& pool);

// The formulations that exist for a system: all but `integrated` if its constraints are not affine in the
// velocity; none without constraints. The first is the default.
std::vector<Formulation> formulations_of(const MechanicalSystem& system, ExpressionPool& pool);

// What a mechanical scene knows as functions of its columns q, v, w, the same in every formulation.
// The columns from the state: components themselves, or functions of them.
Outputs outputs_of(const PosedEquations& equations, const std::vector<std::string>& names,
                   const ExpressionPool& pool);

Constraint constraint_of(const Dynamics& dynamics);

// The energy, with the power of forces and reactions as its rate; with memory the reaction has a term in w'.
// Empty if L depends on t.
Energy energy_of(const Dynamics& dynamics);

// The multipliers by Tarasov & Zaslavsky (36), with w' as the rates of the columns w, and their power.
// `start_exponents`: the powers of t with which the columns w start.
Reactions reactions_of(const Dynamics& dynamics, const std::vector<double>& start_exponents);

// The geometry of the metric at any state, with the names of the coordinates. Forces and constraints are
// evaluated at t = 0, with w = 0.
StateGeometry geometry_of(const Dynamics& dynamics, const std::vector<std::string>& coordinates);

}  // namespace fde::bench::mechanics
