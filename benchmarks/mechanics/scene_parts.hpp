// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

// What a mechanical scene knows as functions of its columns q, v, w, the same in every formulation.
namespace fde::bench::mechanics {

// Whether d^2 L/dv^2 does not depend on v.
bool has_metric(const Dynamics& dynamics);

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
