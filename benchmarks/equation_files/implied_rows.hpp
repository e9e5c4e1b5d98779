// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

// The text with a row for each fractional integral J(f, q), q > 0, and each derivative D(g, q) of a formula
// of t in a right-hand side, whose name takes their place:
//   z = J^q f                    D^q z = f, z(0) = z'(0) = ... = 0,
//   z = D^q g, m - 1 < q < m     D^(m-q) z = g^(m), z(0) = 0,
// with integrals and Caputo derivatives from 0. Derivatives of whole orders remain as they are. Throws
// std::invalid_argument naming file, line and column.
EquationText with_implied_rows(EquationText text, const Parameters& parameters);

}  // namespace fde::bench
