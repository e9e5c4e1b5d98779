#include <array>

#include "weights/families/product_rules.hpp"
#include "weights/family.hpp"

namespace fde {
namespace {

using Real = long double;

// Stirling's correction sum_j B_2j / (2j (2j-1) x^(2j-1)) to ln Gamma(x), for x >= 16 (Abramowitz &
// Stegun 6.1.40).
Real stirling(Real x) {
  constexpr std::array<Real, 8> coefficients{1.0L / 12,   -1.0L / 360,      1.0L / 1260, -1.0L / 1680,
                                             1.0L / 1188, -691.0L / 360360, 1.0L / 156,  -3617.0L / 122400};
  const Real y = 1 / (x * x);
  Real sum = 0;
  for (std::size_t j = coefficients.size(); j-- > 0;) sum = sum * y + coefficients[j];
  return sum / x;
}

// Gamma(k+g) / Gamma(k+1), with the large parts of the two logarithms of Gamma cancelled by hand.
Real gamma_ratio(Real g, Real k) {
  const Real rest =
      (k + g - 0.5L) * std::log1p((g - 1) / (k + 1)) - (g - 1) + stirling(k + g) - stirling(k + 1);
  return std::pow(k + 1, g - 1) * std::exp(rest);
}

Real weight(Real g, Real k) {
  if (k >= 16) return gamma_ratio(g, k) / std::tgamma(g);
  Real product = 1;
  for (Real j = 1; j <= k; ++j) product *= (j - 1 + g) / j;
  return product;
}

// From B(k+g, 1-g) = int_0^inf (e^s - 1)^(-g) e^(-k s) ds. The differences of these weights are the weights
// of the order less 1.
double coefficient(double g, double node, double kernel) {
  return kernel * std::pow(step_mean(node), -(g > 1.0 ? g - 1.0 : g));
}

}  // namespace

constinit const WeightFamily families::grunwald_letnikov{
    .id = "grunwald_letnikov",
    .title = "Grunwald-Letnikov, backward Euler convolution quadrature: (-1)^k binomial(-g, k)",
    .weight = weight,
    .start_weight = [](Real /*g*/, Real /*n*/) -> Real { return 0; },
    .weight_at_order_one = 1.0,
    .step_factor = [](double /*g*/, double power) { return power; },
    .coefficient = coefficient,
    .regular_part = [](double /*g*/, ComplexValue /*mu*/) -> ComplexValue { return 1.0; }};

}  // namespace fde
