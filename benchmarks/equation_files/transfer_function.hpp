// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

// The text with a state z in place of each unknown p that has a transfer function P(s)/Q(s), a quotient of
// sums of real powers of s, with the input u:
//   Q(D) z = u, z(0) = z'(0) = ... = 0,    p = P(D) z,
// as P(s)/Q(s) times the Laplace transform of u is that of p. The name p is then an output. P and Q are not
// reduced, apart from a common power of s. Throws std::invalid_argument naming file, line and column, also
// where the highest order of Q is not above that of P.
EquationText with_states(EquationText text, const Parameters& parameters);

}  // namespace fde::bench
