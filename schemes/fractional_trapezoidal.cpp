// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/multistep_scheme.hpp"

namespace fde {

// omega = ((1+zeta) / (2 (1-zeta)))^g, the trapezoidal rule at g = 1. The stability region is exactly the
// sector in which the exact solution decays.
Scheme fractional_trapezoidal() {
  return multistep_scheme("fractional_trapezoidal", "Fractional trapezoidal rule with start weights",
                          "Lubich, SIAM J. Math. Anal. 17 (1986); Garrappa, Math. Comput. Simul. 110 (2015)",
                          families::fractional_trapezoidal);
}

}  // namespace fde
