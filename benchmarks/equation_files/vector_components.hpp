// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

// The text with the unknowns u[1], u[2], ..., u[size] in place of each unknown u that has a size. Each
// formula of u is one of every component, with its number i and with size; so is the formula of u, or of a
// D(u, q), in [exact]. Throws std::invalid_argument naming file, line and column.
EquationText with_components(EquationText text, const Parameters& parameters);

}  // namespace fde::bench
