// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/product_rules.hpp"

namespace fde {
namespace {

using Real = long double;

// The second difference of a step is known one step later, so lag k belongs to the integral over
// [k+s, k+1+s], s = 1 - g/2.
double coefficient(double g, double node, double kernel) {
  return kernel * (std::tgamma(2 - g) * second_difference_mean(node) * std::exp(-(1 - g / 2) * node));
}

}  // namespace

constinit const WeightFamily families::l2_1_sigma_second_difference = increment_family(
    {.id = "l2_1_sigma_second_difference",
     .title = "what parabolas add to l2_1_sigma, lag k for the bend of the step before, g <= 1",
     .weight = [](Real g, Real k) { return second_difference_weight(g, k + 2 - g / 2); },
     .coefficient = coefficient});

}  // namespace fde
