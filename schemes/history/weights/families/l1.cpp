// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/product_rules.hpp"

namespace fde {
namespace {

using Real = long double;

// From (k+1)^(1-g) - k^(1-g) = (1-g) int_k^(k+1) t^(-g) dt.
double coefficient(double g, double node, double kernel) {
  return kernel * (std::tgamma(2 - g) * step_mean(node) * std::exp(-node));
}

// (1-zeta)^g / ((1-zeta) W) with W = (1-zeta)/zeta Li_(g-1); branches as in the rectangle rule.
ComplexValue regular_part(double g, ComplexValue mu) {
  return std::pow(exp_minus_one(mu) / mu, g - 2.0) * std::exp(mu) / scaled_polylogarithm(g - 1.0, mu);
}

}  // namespace

constinit const WeightFamily families::l1 = increment_family(
    {.id = "l1",
     .title = "L1 rule on the increments of y, g <= 1: (k+1)^(1-g) - k^(1-g)",
     .weight = [](Real g, Real k) { return power_difference(1 - g, k + 1); },
     .coefficient = coefficient,
     .regular_part = regular_part,
     .endpoint_values = [](double /*before*/, double after, double length) -> EndpointValues {
       return {after / length, after / length};
     }});

}  // namespace fde
