// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

bool has_distributed_orders(const EquationText& text);

struct QuadratureNodes {
  int more = 0;                 // than those that nodes_for() gives for a tolerance of 1e-10
  std::optional<double> end{};  // of the times that they are for; empty: that of the file
};

// The text with terms in place of those of distributed order, of a quadrature that changes solutions by about
// 1e-10, or by less with more nodes. Throws std::invalid_argument naming file, line and column.
EquationText with_quadrature(EquationText text, const Parameters& parameters,
                             const QuadratureNodes& nodes = {});

}  // namespace fde::bench
