// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/families/multistep_family.hpp"

namespace fde {
namespace {

using Real = long double;

// omega = ((1 + zeta) / (2 (1 - zeta)))^g
constexpr MultistepRule rule{.rate = 2, .base = {1, 1}, .denominator = 2, .exponent = 1};

// From this lag on the expansions at the two singularities are accurate to rounding.
constexpr Real far = 64;

// The coefficient of zeta^k in (1-zeta)^(-a) (1+zeta)^b = (1-zeta)^(-a) (2 - (1-zeta))^b, from the expansion
// of the last factor in powers of 1-zeta.
Real expansion(Real a, Real b, Real k) {
  constexpr Real negligible = 1e-22L;
  Real weight = binomial_weight(a, k), factor = 1, sum = 0;
  for (Real j = 0; std::abs(factor * weight) > negligible * std::abs(sum); ++j) {
    sum += factor * weight;
    factor *= -(b - j) / (2 * (j + 1));
    a -= 1;
    weight *= a / (k + a);
  }
  return sum * std::pow(Real{2}, b);
}

bool whole(Real g) { return g == std::floor(g); }

// w(k) and v(k) of one order at near lags k >= 1.
struct Near {
  Real order = 0;
  std::vector<Real> whole, alternating;
};

// w by its recurrence, and v by backward recurrence from far lags: u(n) and (-1)^n v(n) both satisfy
// n w(n) = 2g w(n-1) + (n-2) w(n-2), and v grows backwards, which makes the recurrence stable. The tables of
// the last order are cached.
const Near& near(Real g) {
  thread_local Near last;
  if (last.order == g) return last;
  constexpr auto count = static_cast<std::size_t>(far);
  last = {g, first_weights_of<rule>(g, count), std::vector<Real>(count, Real{0})};
  if (whole(g)) return last;
  Real later = expansion(-g, -g, far + 1), value = expansion(-g, -g, far);
  for (std::size_t k = count; k >= 1; --k) {
    last.alternating[k - 1] = value;
    const Real n = static_cast<Real>(k) + 1, earlier = k > 1 ? (n * later + 2 * g * value) / (n - 2) : 0;
    later = value;
    value = earlier;
  }
  return last;
}

Real alternating_weight(Real g, Real k) {
  if (k <= far) return near(g).alternating[static_cast<std::size_t>(k) - 1];
  return whole(g) ? 0 : expansion(-g, -g, k);
}

Real signed_alternating(Real g, Real k) {
  return std::fmod(k, Real{2}) == 0 ? alternating_weight(g, k) : -alternating_weight(g, k);
}

std::vector<Real> first_weights(Real g, std::size_t count) { return first_weights_of<rule>(g, count); }

Real weight(Real g, Real k) {
  if (k <= far) return near(g).whole[static_cast<std::size_t>(k) - 1];
  return expansion(g, g, k) + signed_alternating(g, k);
}

Real smooth_weight(Real g, Real k) {
  return k <= far ? weight(g, k) - signed_alternating(g, k) : expansion(g, g, k);
}

double tanh_mean(double s) { return s == 0.0 ? 0.5 : std::tanh(0.5 * s) / s; }

// The branch cut from 1 on: u(k) = sin(pi g)/pi int_0^inf coth(s/2)^g exp(-k s) ds, the integrand of
// grunwald_letnikov times (1 + exp(s))^g.
double smooth_coefficient(double g, double node, double kernel) {
  return families::grunwald_letnikov.coefficient(g, node, kernel) * std::pow(1.0 + std::exp(node), g);
}

// The branch cut from -1 on: v(k) = -sin(pi g)/pi int_0^inf tanh(s/2)^g exp(-k s) ds; the kernel with
// exponent a = 1 - g or 2 - g has the density sin(pi a)/pi s^(-a).
double alternating_coefficient(double g, double node, double kernel) {
  const double factor = g < 1.0 ? -node : node * node;
  return kernel * factor * std::pow(tanh_mean(node), g);
}

// (1 + zeta)^g, with an accurate argument of 1 + zeta also near zeta = -1.
ComplexValue regular_part(double g, ComplexValue mu) {
  return std::pow(2.0 * std::cosh(0.5 * mu), g) * std::exp(0.5 * g * mu);
}

constexpr WeightFamily smooth{.id = "fractional_trapezoidal_smooth",
                              .title = "the part of fractional_trapezoidal from its singularity at 1",
                              .weight = smooth_weight,
                              .coefficient = smooth_coefficient};

constexpr WeightFamily alternating{.id = "fractional_trapezoidal_alternating",
                                   .title = "the part of fractional_trapezoidal from its singularity at -1",
                                   .weight = alternating_weight,
                                   .exponent = [](long double g) { return (g < 1 ? 1 : 2) - g; },
                                   .coefficient = alternating_coefficient};

}  // namespace

constinit const WeightFamily families::fractional_trapezoidal{
    .id = "fractional_trapezoidal",
    .title = "fractional trapezoidal rule: coefficients of ((1+zeta)/(1-zeta))^g",
    .weight = weight,
    .first_weights = first_weights,
    .weight_at_order_one = 2.0,
    .step_factor = [](Real g) { return std::pow(Real(0.5), g); },
    .smooth_part = &smooth,
    .alternating_part = &alternating,
    .multistep = &rule,
    .regular_part = regular_part};

}  // namespace fde
