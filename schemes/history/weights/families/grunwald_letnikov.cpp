// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/multistep_family.hpp"
#include "fdebench/schemes/history/weights/families/product_rules.hpp"
#include "fdebench/schemes/history/weights/family.hpp"

namespace fde {
namespace {

// From B(k+g, 1-g) = int_0^inf (e^s - 1)^(-g) e^(-k s) ds. The differences of the weights of order g are the
// weights of order g - 1.
double grunwald_letnikov_coefficient(double g, double node, double kernel) {
  return kernel * std::pow(step_mean(node), -(g > 1.0 ? g - 1.0 : g));
}

}  // namespace

constinit const WeightFamily families::grunwald_letnikov{
    .id = "grunwald_letnikov",
    .title = "Grunwald-Letnikov, backward Euler convolution quadrature: (-1)^k binomial(-g, k)",
    .weight = binomial_weight,
    .first_weights =
        [](long double g, std::size_t count) {
          std::vector<long double> w(count);
          long double last = 1;
          for (std::size_t k = 1; k <= count; ++k) {
            const auto lag = static_cast<long double>(k);
            w[k - 1] = last *= (lag - 1 + g) / lag;
          }
          return w;
        },
    .first_sample_weight = [](long double /*g*/, long double /*n*/) -> long double { return 0; },
    .weight_at_order_one = 1.0,
    .step_factor = [](long double /*g*/) -> long double { return 1; },
    .coefficient = grunwald_letnikov_coefficient,
    .regular_part = [](double /*g*/, ComplexValue /*mu*/) -> ComplexValue { return 1.0; }};

}  // namespace fde
