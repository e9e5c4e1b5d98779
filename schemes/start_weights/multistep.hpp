#pragma once

#include "start_weights/start_powers.hpp"
#include "stepping/scheme.hpp"
#include "weights/family.hpp"

namespace fde {

// The scheme of a multistep rule with start weights:
//   y_n = T_n + h^g omega_0 (sum_{j<=n} w(n-j) f_j + sum_{j<s} W(n, j) f_j).
// Theory of its rates: powers of f that have start weights are exact; any other t^r costs h^(1+r) at a fixed
// time (Lubich 1986, theorem 2.1) and h^(g+r) in the first steps.
Scheme multistep_scheme(std::string_view id, std::string_view title, std::string_view source,
                        const WeightFamily& family);

// The rate of such a rule with these start powers, of rows whose f starts like t^(p - g).
double multistep_rate(const WeightFamily& family, const StartPowers& start, const Problem& problem,
                      const Smoothness& smoothness, double grading, Norm norm);

}  // namespace fde
