// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/multistep_scheme.hpp"

namespace fde {
namespace {

constexpr std::string_view of_bdf =
    "Lubich, SIAM J. Math. Anal. 17 (1986); start weights as in Garrappa, Math. Comput. Simul. 110 (2015)";
constexpr std::string_view of_newton_gregory =
    "Lubich, SIAM J. Math. Anal. 17 (1986); Galeone & Garrappa, J. Comput. Appl. Math. 228 (2009)";

}  // namespace

// Convolution quadrature by the backward differentiation formulas, omega = delta(zeta)^(-g) with
// delta = sum_{k<=p} (1-zeta)^k / k. At g = 1 these are the classical formulas. bdf1 is grunwald_letnikov.
Scheme bdf2() {
  return multistep_scheme("bdf2", "Fractional BDF2 with start weights", of_bdf, families::bdf2);
}
Scheme bdf3() {
  return multistep_scheme("bdf3", "Fractional BDF3 with start weights", of_bdf, families::bdf3);
}
Scheme bdf4() {
  return multistep_scheme("bdf4", "Fractional BDF4 with start weights", of_bdf, families::bdf4);
}
Scheme bdf5() {
  return multistep_scheme("bdf5", "Fractional BDF5 with start weights", of_bdf, families::bdf5);
}
Scheme bdf6() {
  return multistep_scheme("bdf6", "Fractional BDF6 with start weights", of_bdf, families::bdf6);
}

// The generalised Adams-Moulton methods omega = (1-zeta)^(-g) (1 - g/2 (1-zeta) + ...): at g = 1 the
// trapezoidal rule and the two-step Adams-Moulton method.
Scheme newton_gregory_2() {
  return multistep_scheme("newton_gregory_2", "Newton-Gregory rule of rate 2 with start weights",
                          of_newton_gregory, families::newton_gregory_2);
}
Scheme newton_gregory_3() {
  return multistep_scheme("newton_gregory_3", "Newton-Gregory rule of rate 3 with start weights",
                          of_newton_gregory, families::newton_gregory_3);
}

// omega = ((1+zeta) / (2 (1-zeta)))^g, the trapezoidal rule at g = 1. The stability region is exactly the
// sector in which the exact solution decays.
Scheme fractional_trapezoidal() {
  return multistep_scheme("fractional_trapezoidal", "Fractional trapezoidal rule with start weights",
                          "Lubich, SIAM J. Math. Anal. 17 (1986); Garrappa, Math. Comput. Simul. 110 (2015)",
                          families::fractional_trapezoidal);
}

}  // namespace fde
