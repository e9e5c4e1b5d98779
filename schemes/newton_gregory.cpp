// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/multistep_scheme.hpp"

namespace fde {
namespace {

constexpr std::string_view newton_gregory_source =
    "Lubich, SIAM J. Math. Anal. 17 (1986); Galeone & Garrappa, J. Comput. Appl. Math. 228 (2009)";

}  // namespace

// The generalised Adams-Moulton methods omega = (1-zeta)^(-g) (1 - g/2 (1-zeta) + ...): at g = 1 the
// trapezoidal rule and the two-step Adams-Moulton method.
Scheme newton_gregory_2() {
  return multistep_scheme("newton_gregory_2", "Newton-Gregory rule of rate 2 with start weights",
                          newton_gregory_source, families::newton_gregory_2);
}
Scheme newton_gregory_3() {
  return multistep_scheme("newton_gregory_3", "Newton-Gregory rule of rate 3 with start weights",
                          newton_gregory_source, families::newton_gregory_3);
}

}  // namespace fde
