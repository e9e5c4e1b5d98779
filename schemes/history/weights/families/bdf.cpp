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

}  // namespace fde
