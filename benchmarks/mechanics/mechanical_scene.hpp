// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/mechanics/formulation.hpp"
#include "fdebench/benchmarks/mechanics/mechanical_system.hpp"
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

}  // namespace fde::bench::mechanics
