// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

bool has_distributed_orders(const EquationText& text);

// The text with terms in place of those of distributed order, of a quadrature that changes solutions by about
// 1e-10 (nodes_for()), or by less with `more_nodes` in each. Throws std::invalid_argument naming file, line
// and column.
EquationText with_quadrature(EquationText text, const Parameters& parameters, int more_nodes = 0);

}  // namespace fde::bench
