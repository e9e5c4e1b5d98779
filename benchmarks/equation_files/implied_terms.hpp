// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

// The text with a term for each D(x, q) of a right-hand side whose order q, below the leading one of x, no
// term of x has: D(x, q) is added to both sides of the equation of x, which makes it a node of the chain of
// x. So variable coefficients are written as they are: y'' = -sin(t) D^0.5 y. An equation with a factor or
// without chain is left as it is.
EquationText with_implied_terms(EquationText text, const Parameters& parameters);

}  // namespace fde::bench
