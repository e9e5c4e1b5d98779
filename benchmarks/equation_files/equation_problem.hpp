// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The equations of the system for z_i = y_i - v_i, where v_i = J^(order_i) of the loads c t^-p, 0 < p <
// order_i, of row i: without these loads the right-hand sides are finite at t = 0. The outputs are the
// columns of y. nullopt if no row has such a load, or if one has a load whose response is not 0 at t = 0.
std::optional<PosedProblem> without_singular_loads(const EquationSystem& system, const Problem& problem,
                                                   const std::vector<SystemColumn>& columns,
                                                   ExpressionPool& pool);

}  // namespace fde::bench
