#include "weights/families/parabola.hpp"
#include "weights/family.hpp"

namespace fde {
namespace {

using Real = long double;

double coefficient(double g, double node, double kernel) {
  return kernel * (std::tgamma(2 - g) * bend_mean(node));
}

}  // namespace

constinit const WeightFamily families::l1_bend{
    .id = "l1_bend",
    .title = "what L1-2 adds to l1: a parabola in place of each line, g <= 1",
    .weighs_increments = true,
    .weight = [](Real g, Real k) { return bend_weight(g, k + 1); },
    .start_weight = [](Real /*g*/, Real /*n*/) -> Real { return 0; },
    .weight_at_order_one = 0.0,
    .step_factor = [](double g) { return std::tgamma(2.0 - g); },
    .coefficient = coefficient,
    .ends = [](double /*before*/, double after, double length) -> Ends {
      return {-after / length, after / length};
    }};

}  // namespace fde
