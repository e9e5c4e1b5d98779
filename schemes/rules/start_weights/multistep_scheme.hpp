// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/weights/family.hpp"
#include "fdebench/schemes/rules/start_weights/start_weights.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// The scheme of a fractional linear multistep method with starting weights:
//   y_n = T_n + h^g omega_0 (sum_{j<=n} w(n-j) f_j + sum_{j<s} W(n, j) f_j).
// Its theoretical rate: powers of f with starting weights are exact; any other t^r has an error h^(1+r) at a
// fixed time (Lubich 1986, theorem 2.1) and h^(g+r) in the first steps. Precondition: family.multistep is
// set; `family` must outlive the scheme.
Scheme multistep_scheme(std::string_view id, std::string_view title, std::string_view source,
                        const WeightFamily& family);

// The theoretical rate of such a scheme with these starting powers; a power p of a row of order g
// (Smoothness) is a power p - g of its f.
double multistep_rate(const WeightFamily& family, const StartingPowers& start, const Problem& problem,
                      const Smoothness& smoothness, double grading, Norm norm);

}  // namespace fde
