// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

// The text with Caputo derivatives in place of Riemann-Liouville derivatives. The solution of
//   D^a y = f(t, y), n - 1 < a <= n,   D^(a-k) y(0) = b_k, k = 1, ..., n   (D^(a-n) is J^(n-a))
// is y = w + sum_k b_k t^(a-k)/Gamma(a-k+1) with w = J^a f (Diethelm, The Analysis of Fractional Differential
// Equations, 2010, lemma 5.2). Where f is linear in y with constant coefficients, such powers of t in f have
// the integrals t^(p+a)/Gamma(p+a+1) in y, which are powers again: as many are taken as leave powers of at
// least 1 in the right-hand side of w, D^a w = ... with w(0) = w'(0) = ... = 0. The same is done for unknowns
// with Caputo derivatives whose right-hand sides contain y. The names of all these unknowns are then outputs.
// Throws std::invalid_argument naming file, line and column where f is not of this kind and a b_k is not 0.
EquationText with_caputo_derivatives(EquationText text, const Parameters& parameters);

}  // namespace fde::bench
