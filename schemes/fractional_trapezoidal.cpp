#include "start_weights/multistep.hpp"

namespace fde {

// ((1+zeta) / (2 (1-zeta)))^g: the power of the trapezoidal rule, which it is at order 1. Stable exactly
// where the equation is.
Scheme fractional_trapezoidal() {
  return multistep_scheme("fractional_trapezoidal", "Fractional trapezoidal rule with start weights",
                          "Lubich, SIAM J. Math. Anal. 17 (1986); Garrappa, Math. Comput. Simul. 110 (2015)",
                          families::fractional_trapezoidal);
}

}  // namespace fde
