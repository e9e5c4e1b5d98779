// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/product_rules.hpp"

namespace fde {
namespace {

using Real = long double;

double coefficient(double g, double node, double kernel) {
  return kernel * (std::tgamma(2 - g) * second_difference_mean(node));
}

}  // namespace

constinit const WeightFamily families::l1_second_difference = increment_family(
    {.id = "l1_second_difference",
     .title = "what L1-2 adds to l1: a parabola in place of each line, g <= 1",
     .weight = [](Real g, Real k) { return second_difference_weight(g, k + 1); },
     .coefficient = coefficient,
     .endpoint_values = [](double /*before*/, double after, double length) -> EndpointValues {
       return {-after / length, after / length};
     }});

}  // namespace fde
