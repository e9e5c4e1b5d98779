// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The columns of the output: those of [columns], or else columns_of(system). A column D(x, q) is a row of the
// problem, or, if q is the leading order, the right-hand side of one. Throws std::invalid_argument naming
// file, line and column.
std::vector<SystemColumn> output_columns(const EquationSystem& system, FileFormulas& formulas);

// The functions of the rows that give these columns.
Outputs outputs_of(const std::vector<SystemColumn>& columns, Eigen::Index rows, ExpressionPool& pool);

}  // namespace fde::bench
