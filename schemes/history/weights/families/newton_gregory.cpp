// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/multistep_family.hpp"

namespace fde {
namespace {

// The exact integral has the symbol (-ln zeta)^(-g) = u^(-g) (1 + u/2 + u^2/3 + ...)^(-g), u = 1 - zeta. The
// last factor is truncated after u, or u^2:
//   1 - g/2 u + (g^2/8 - 5g/24) u^2.
// At g = 1 this is the trapezoidal rule (1 + zeta)/2, or the Adams-Moulton rule (5 + 8 zeta - zeta^2)/12.
constexpr MultistepRule second{.rate = 2, .corrections = {{{24}, {0, -12}}}};
constexpr MultistepRule third{.rate = 3, .corrections = {{{24}, {0, -12}, {0, -5, 3}}}};

}  // namespace

constinit const WeightFamily families::newton_gregory_2 =
    multistep_family<second>("newton_gregory_2", "Newton-Gregory convolution quadrature of rate 2");
constinit const WeightFamily families::newton_gregory_3 =
    multistep_family<third>("newton_gregory_3", "Newton-Gregory convolution quadrature of rate 3");

}  // namespace fde
