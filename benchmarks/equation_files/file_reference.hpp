// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/reference/reference.hpp"

namespace fde::bench {

// The exact solution in these columns, from [exact] or from the form of the equations: linear with constant
// coefficients, or the pendulum x'' = c sin x. Without `at` if there is none. Throws std::invalid_argument
// naming file, line and column if [exact] is wrong.
reference::Reference file_reference(const EquationSystem& system, const Problem& problem,
                                    const std::vector<SystemColumn>& columns, FileFormulas& formulas);

}  // namespace fde::bench
