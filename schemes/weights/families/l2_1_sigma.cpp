#include "weights/families/product_rules.hpp"
#include "weights/family.hpp"

namespace fde {
namespace {

using Real = long double;

// From (k+s)^(1-g) - (k-1+s)^(1-g) = (1-g) int_(k-1+s)^(k+s) t^(-g) dt, s = 1 - g/2.
double coefficient(double g, double node, double kernel) {
  return kernel * (std::tgamma(2 - g) * step_mean(node) * std::exp(-(1 - g / 2) * node));
}

}  // namespace

constinit const WeightFamily families::l2_1_sigma{
    .id = "l2_1_sigma",
    .title = "L1 rule at t_(n-1+s), s = 1 - g/2, on the increments of y, g <= 1: (k+s)^(1-g) - (k-1+s)^(1-g)",
    .weighs_increments = true,
    .weight = [](Real g, Real k) { return power_difference(1 - g, k + 1 - g / 2); },
    .start_weight = [](Real /*g*/, Real /*n*/) -> Real { return 0; },
    .weight_at_order_one = 0.0,
    .step_factor = [](double g) { return std::tgamma(2.0 - g); },
    .coefficient = coefficient};

}  // namespace fde
