// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The equations of motion with multipliers of a file with [mechanics], in its parameters, from its
// Lagrangian: one of order 2 for each coordinate and 0 = f for each constraint. Empty for an extremum, and if
// a formula would be too long.
std::vector<EquationFormula> mechanical_equations(const EquationText& text);

// Whether these are not empty and short enough to be shown in place of the statements of the file.
bool are_readable(const std::vector<EquationFormula>& equations);

// What such a file states: the Lagrangian, the forces and the constraints.
std::vector<DisplayEquation> mechanical_statements(const EquationText& text);

}  // namespace fde::bench
