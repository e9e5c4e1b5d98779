// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/product_rules.hpp"
#include "fdebench/schemes/history/weights/family.hpp"

namespace fde {
namespace {

// From k^g - (k-1)^g = g int_(k-1)^k t^(g-1) dt.
double rectangle_coefficient(double g, double node, double kernel) {
  return kernel * (std::tgamma(g + 1) * step_mean(node) * difference_mean(g, node));
}

// (1-zeta)^g (1-zeta) Li_(-g)(zeta), zeta = exp(mu). The arguments of 1-zeta and -mu are within a right
// angle, so the principal power of their ratio has no branch jump.
ComplexValue rectangle_regular_part(double g, ComplexValue mu) {
  return std::pow(exp_minus_one(mu) / mu, 1.0 + g) * scaled_polylogarithm(-g, mu);
}

}  // namespace

constinit const WeightFamily families::rectangle{
    .id = "rectangle",
    .title = "product rectangle rule, Adams-Bashforth predictor: k^g - (k-1)^g",
    .weight = power_difference,
    .weight_at_order_one = 1.0,
    .step_factor = [](long double g) { return 1 / std::tgamma(g + 1); },
    .coefficient = rectangle_coefficient,
    .regular_part = rectangle_regular_part,
    .endpoint_values = [](double before, double /*after*/, double /*length*/) -> EndpointValues {
      return {before, before};
    }};

}  // namespace fde
