// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/multistep_scheme.hpp"

namespace fde {
namespace {

constexpr std::string_view bdf_source =
    "Lubich, SIAM J. Math. Anal. 17 (1986); start weights as in Garrappa, Math. Comput. Simul. 110 (2015)";

}  // namespace

// Convolution quadrature by the backward differentiation formulas, omega = delta(zeta)^(-g) with
// delta = sum_{k<=p} (1-zeta)^k / k. At g = 1 these are the classical formulas. bdf1 is grunwald_letnikov.
Scheme bdf2() {
  return multistep_scheme("bdf2", "Fractional BDF2 with start weights", bdf_source, families::bdf2);
}
Scheme bdf3() {
  return multistep_scheme("bdf3", "Fractional BDF3 with start weights", bdf_source, families::bdf3);
}
Scheme bdf4() {
  return multistep_scheme("bdf4", "Fractional BDF4 with start weights", bdf_source, families::bdf4);
}
Scheme bdf5() {
  return multistep_scheme("bdf5", "Fractional BDF5 with start weights", bdf_source, families::bdf5);
}
Scheme bdf6() {
  return multistep_scheme("bdf6", "Fractional BDF6 with start weights", bdf_source, families::bdf6);
}

}  // namespace fde
