// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/product_rules.hpp"

namespace fde {
namespace {

using Real = long double;

// (1-zeta)^g / ((1-zeta) W) with W = (1-zeta)/zeta Li_(g-1); branches as in the rectangle rule.
ComplexValue l1_regular_part(double g, ComplexValue mu) {
  return std::pow(exp_minus_one(mu) / mu, g - 2.0) * std::exp(mu) / scaled_polylogarithm(g - 1.0, mu);
}

}  // namespace

constinit const WeightFamily families::l1 = increment_family(
    {.id = "l1",
     .title = "L1 rule on the increments of y, g <= 1: (k+1)^(1-g) - k^(1-g)",
     .weight = [](Real g, Real k) { return power_difference(1 - g, k + 1); },
     // From (k+1)^(1-g) - k^(1-g) = (1-g) int_k^(k+1) t^(-g) dt.
     .coefficient =
         [](double g, double node, double kernel) {
           return kernel * (std::tgamma(2 - g) * step_mean(node) * std::exp(-node));
         },
     .regular_part = l1_regular_part,
     .endpoint_values = [](double /*before*/, double after, double length) -> EndpointValues {
       return {after / length, after / length};
     }});

constinit const WeightFamily families::l1_second_difference = increment_family(
    {.id = "l1_second_difference",
     .title = "what L1-2 adds to l1: a parabola in place of each line, g <= 1",
     .weight = [](Real g, Real k) { return second_difference_weight(g, k + 1); },
     .coefficient =
         [](double g, double node, double kernel) {
           return kernel * (std::tgamma(2 - g) * second_difference_mean(node));
         },
     .endpoint_values = [](double /*before*/, double after, double length) -> EndpointValues {
       return {-after / length, after / length};
     }});

constinit const WeightFamily families::l2_1_sigma = increment_family(
    {.id = "l2_1_sigma",
     .title =
         "L1 rule at t_(n-1+s), s = 1 - g/2, on the increments of y, g <= 1: (k+s)^(1-g) - (k-1+s)^(1-g)",
     .weight = [](Real g, Real k) { return power_difference(1 - g, k + 1 - g / 2); },
     // From (k+s)^(1-g) - (k-1+s)^(1-g) = (1-g) int_(k-1+s)^(k+s) t^(-g) dt, s = 1 - g/2.
     .coefficient =
         [](double g, double node, double kernel) {
           return kernel * (std::tgamma(2 - g) * step_mean(node) * std::exp(-(1 - g / 2) * node));
         }});

// The second difference of a step is known one step later, so lag k belongs to the integral over
// [k+s, k+1+s], s = 1 - g/2.
constinit const WeightFamily families::l2_1_sigma_second_difference = increment_family(
    {.id = "l2_1_sigma_second_difference",
     .title = "what parabolas add to l2_1_sigma, lag k for the bend of the step before, g <= 1",
     .weight = [](Real g, Real k) { return second_difference_weight(g, k + 2 - g / 2); },
     .coefficient =
         [](double g, double node, double kernel) {
           return kernel *
                  (std::tgamma(2 - g) * second_difference_mean(node) * std::exp(-(1 - g / 2) * node));
         }});

}  // namespace fde
