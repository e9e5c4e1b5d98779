// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/multistep_family.hpp"

namespace fde {
namespace {

// omega = delta(zeta)^(-g), delta = sum_{k<=p} (1-zeta)^k / k the polynomial of the backward differentiation
// formula. The bases are delta / (1-zeta); decay is 1 / (the smallest modulus of a zero of the base).
constexpr MultistepRule bdf2_rule{.rate = 2, .base = {3, -1}, .denominator = 2, .decay = 1.0 / 3.0};
constexpr MultistepRule bdf3_rule{.rate = 3, .base = {11, -7, 2}, .denominator = 6, .decay = 0.42641};
constexpr MultistepRule bdf4_rule{.rate = 4, .base = {25, -23, 13, -3}, .denominator = 12, .decay = 0.56087};
constexpr MultistepRule bdf5_rule{
    .rate = 5, .base = {137, -163, 137, -63, 12}, .denominator = 60, .decay = 0.70871};
constexpr MultistepRule bdf6_rule{
    .rate = 6, .base = {147, -213, 237, -163, 62, -10}, .denominator = 60, .decay = 0.86338};

// The exact integral has the symbol (-ln zeta)^(-g) = u^(-g) (1 + u/2 + u^2/3 + ...)^(-g), u = 1 - zeta. The
// last factor is truncated after u, or u^2:
//   1 - g/2 u + (g^2/8 - 5g/24) u^2.
// At g = 1 this is the trapezoidal rule (1 + zeta)/2, or the Adams-Moulton rule (5 + 8 zeta - zeta^2)/12.
constexpr MultistepRule newton_gregory_2_rule{.rate = 2, .corrections = {{{24}, {0, -12}}}};
constexpr MultistepRule newton_gregory_3_rule{.rate = 3, .corrections = {{{24}, {0, -12}, {0, -5, 3}}}};

}  // namespace

constinit const WeightFamily families::bdf2 =
    multistep_family<bdf2_rule>("bdf2", "BDF2 convolution quadrature");
constinit const WeightFamily families::bdf3 =
    multistep_family<bdf3_rule>("bdf3", "BDF3 convolution quadrature");
constinit const WeightFamily families::bdf4 =
    multistep_family<bdf4_rule>("bdf4", "BDF4 convolution quadrature");
constinit const WeightFamily families::bdf5 =
    multistep_family<bdf5_rule>("bdf5", "BDF5 convolution quadrature");
constinit const WeightFamily families::bdf6 =
    multistep_family<bdf6_rule>("bdf6", "BDF6 convolution quadrature");
constinit const WeightFamily families::newton_gregory_2 = multistep_family<newton_gregory_2_rule>(
    "newton_gregory_2", "Newton-Gregory convolution quadrature of rate 2");
constinit const WeightFamily families::newton_gregory_3 = multistep_family<newton_gregory_3_rule>(
    "newton_gregory_3", "Newton-Gregory convolution quadrature of rate 3");

}  // namespace fde
