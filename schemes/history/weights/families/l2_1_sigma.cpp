// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/product_rules.hpp"

namespace fde {
namespace {

using Real = long double;

// From (k+s)^(1-g) - (k-1+s)^(1-g) = (1-g) int_(k-1+s)^(k+s) t^(-g) dt, s = 1 - g/2.
double coefficient(double g, double node, double kernel) {
  return kernel * (std::tgamma(2 - g) * step_mean(node) * std::exp(-(1 - g / 2) * node));
}

}  // namespace

constinit const WeightFamily families::l2_1_sigma = increment_family(
    {.id = "l2_1_sigma",
     .title =
         "L1 rule at t_(n-1+s), s = 1 - g/2, on the increments of y, g <= 1: (k+s)^(1-g) - (k-1+s)^(1-g)",
     .weight = [](Real g, Real k) { return power_difference(1 - g, k + 1 - g / 2); },
     .coefficient = coefficient});

}  // namespace fde
