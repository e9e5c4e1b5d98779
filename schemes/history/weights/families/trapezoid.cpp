// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/product_rules.hpp"
#include "fdebench/schemes/history/weights/family.hpp"

namespace fde {
namespace {

using Real = long double;
constexpr Real negligible = 1e-21L;

// 2 k^(g+1) sum_{m>=1} binomial(g+1, 2m) k^(-2m): the second difference by the binomial series, without the
// terms that cancel.
Real trapezoid_weight(Real g, Real k) {
  if (k == 1) return 2 * std::expm1(g * std::log(Real{2}));
  const Real x = 1 / (k * k);
  Real term = 1, sum = 1;
  for (Real m = 2; std::abs(term) > negligible; m += 2) {
    term *= x * (g + 1 - m) * (g - m) / ((m + 1) * (m + 2));
    sum += term;
  }
  return g * (g + 1) * std::pow(k, g - 1) * sum;
}

// (n-1)^(g+1) - (n-1-g) n^g (Yin, Liu & Anh 2007, eq. 3.7, first line) as
// n^(g+1) sum_{m>=2} binomial(g+1, m) (-1/n)^m.
Real first_sample_weight(Real g, Real n) {
  if (n == 1) return g;
  const Real x = 1 / n;
  Real term = 0.5L, sum = term;
  for (Real m = 2; std::abs(term) > negligible; m += 1) {
    term *= x * (m - 1 - g) / (m + 1);
    sum += term;
  }
  return g * (g + 1) * std::pow(n, g - 1) * sum;
}

// The integral of the kernel with a hat function on [k-1, k+1].
double trapezoid_coefficient(double g, double node, double kernel) {
  const double mean = step_mean(node);
  return kernel * (std::tgamma(g + 2) * mean * mean * std::exp(-node) * difference_mean(g, node));
}

// (D(s) - 1) / s = sum_k s^k / (k+2)!, for the moderate s >= 0 of the nodes.
double half_hat(double s) {
  double term = 0.5, sum = term;
  for (int k = 3; term > 1e-18 * sum; ++k) {
    term *= s / k;
    sum += term;
  }
  return sum;
}

double first_sample_coefficient(double g, double node, double kernel) {
  return std::tgamma(g + 2.0) * (kernel * (half_hat(node) * difference_mean(g, node)));
}

// (1-zeta)^g (1-zeta)^2/zeta Li_(-g-1)(zeta); branches as in the rectangle rule.
ComplexValue trapezoid_regular_part(double g, ComplexValue mu) {
  return std::pow(exp_minus_one(mu) / mu, 2.0 + g) / std::exp(mu) * scaled_polylogarithm(-g - 1.0, mu);
}

}  // namespace

constinit const WeightFamily families::trapezoid{
    .id = "trapezoid",
    .title = "product trapezoidal rule, Adams-Moulton corrector: (k+1)^(g+1) - 2 k^(g+1) + (k-1)^(g+1)",
    .weight = trapezoid_weight,
    .first_sample_weight = first_sample_weight,
    .weight_at_order_one = 2.0,
    .step_factor = [](Real g) { return 1 / std::tgamma(g + 2); },
    .coefficient = trapezoid_coefficient,
    .first_sample_coefficient = first_sample_coefficient,
    .regular_part = trapezoid_regular_part,
    .endpoint_values = [](double before, double after, double /*length*/) -> EndpointValues {
      return {before, after};
    }};

}  // namespace fde
