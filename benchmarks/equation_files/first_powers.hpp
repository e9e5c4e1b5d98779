// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"

namespace fde::bench {

// For each unknown a lower bound of the powers of t in its right-hand side at t = 0: 0 if it is not 0 there,
// else the smallest power that can occur, from the first powers of the unknowns. `values`: those of the
// expressions at t = 0. Precondition: there are no algebraic rows, and the right-hand sides are smooth at the
// start apart from powers of t.
std::vector<double> first_powers(const EquationSystem& system, const ExpressionPool& pool,
                                 const std::vector<double>& values);

}  // namespace fde::bench
