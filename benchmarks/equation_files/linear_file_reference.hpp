// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/reference/reference.hpp"

namespace fde::bench {

// The exact solution in the columns if the equations are linear in the unknowns with constant coefficients
// and loads c t^p, or c switched on at a time: an inverse Laplace transform. nullopt otherwise, or for more
// than 12 rows. Numbers are read as their shortest decimals. If a number of the equations is not such a
// decimal, for instance 1/3, the reference has no `digits`, and the effect is included in its bound.
std::optional<reference::Reference> linear_file_reference(const EquationSystem& system,
                                                          const Problem& problem, ExpressionPool& pool);

}  // namespace fde::bench
