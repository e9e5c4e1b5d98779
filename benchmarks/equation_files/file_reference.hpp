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

// Columns from [exact], with a bound of the rounding errors: `wanted`, derivatives of unknowns, of which
// [exact] may give those of `all`. A derivative of an unknown that is not given is derived from the unknown
// if its order is 1 or if the unknown is a sum of powers of t. Throws std::invalid_argument naming file, line
// and column of a formula that is not one of t, and of a column that is missing.
reference::Reference exact_columns(const EquationText& text, const Parameters& parameters,
                                   const std::vector<SystemColumn>& all,
                                   const std::vector<SystemColumn>& wanted);

}  // namespace fde::bench
