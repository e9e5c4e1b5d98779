#include "weights/weights.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

namespace fde {
namespace {

// Extended precision inside, so that what is left at the end is the rounding to double.
using Real = long double;
constexpr Real negligible = 1e-21L;

// k^g - (k-1)^g = k^g (1 - (1 - 1/k)^g).
Real rectangle(Real g, Real k) {
  if (k == 1) return 1;
  return -std::pow(k, g) * std::expm1(g * std::log1p(-1 / k));
}

// 2 k^(g+1) sum_{m>=1} binomial(g+1, 2m) k^(-2m): the even part of (1 + 1/k)^(g+1), without its cancelling
// terms.
Real trapezoid(Real g, Real k) {
  if (k == 1) return 2 * std::expm1(g * std::log(Real{2}));
  const Real x = 1 / (k * k);
  Real term = 1, sum = 1;
  for (Real m = 2; std::abs(term) > negligible; m += 2) {
    term *= x * (g + 1 - m) * (g - m) / ((m + 1) * (m + 2));
    sum += term;
  }
  return g * (g + 1) * std::pow(k, g - 1) * sum;
}

// n^(g+1) sum_{m>=2} binomial(g+1, m) (-1/n)^m.
Real trapezoid_start(Real g, Real n) {
  if (n == 1) return g;
  const Real x = 1 / n;
  Real term = 0.5L, sum = term;
  for (Real m = 2; std::abs(term) > negligible; m += 1) {
    term *= x * (m - 1 - g) / (m + 1);
    sum += term;
  }
  return g * (g + 1) * std::pow(n, g - 1) * sum;
}

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

Real grunwald_letnikov(Real g, Real k) {
  if (k >= 16) return gamma_ratio(g, k) / std::tgamma(g);
  Real product = 1;
  for (Real j = 1; j <= k; ++j) product *= (j - 1 + g) / j;
  return product;
}

Real extended_weight(const WeightTable& table, std::int64_t lag) {
  const Real g = table.order, k = static_cast<Real>(lag);
  switch (table.family) {
    case WeightFamily::rectangle:
      return rectangle(g, k);
    case WeightFamily::trapezoid:
      return trapezoid(g, k);
    case WeightFamily::grunwald_letnikov:
      return grunwald_letnikov(g, k);
    case WeightFamily::l1:
      return rectangle(1 - g, k + 1);
  }
  std::abort();
}

}  // namespace

double weight(const WeightTable& table, std::int64_t lag) {
  return static_cast<double>(extended_weight(table, lag));
}

double weight_increment(const WeightTable& table, std::int64_t lag) {
  return static_cast<double>(extended_weight(table, lag) - (lag == 1 ? 0 : extended_weight(table, lag - 1)));
}

std::optional<double> constant_weight(const WeightTable& table) {
  if (table.order != 1.0) return std::nullopt;
  return weight(table, 1);
}

std::optional<double> start_weight(const WeightTable& table, std::int64_t n) {
  switch (table.family) {
    case WeightFamily::rectangle:
      return std::nullopt;
    case WeightFamily::trapezoid:
      return static_cast<double>(trapezoid_start(table.order, static_cast<Real>(n)));
    case WeightFamily::grunwald_letnikov:
    case WeightFamily::l1:
      return 0.0;
  }
  std::abort();
}

double step_factor(const WeightTable& table, double length) {
  const double g = table.order, power = std::pow(length, g);
  switch (table.family) {
    case WeightFamily::rectangle:
      return power / std::tgamma(g + 1.0);
    case WeightFamily::trapezoid:
      return power / std::tgamma(g + 2.0);
    case WeightFamily::grunwald_letnikov:
      return power;
    case WeightFamily::l1:
      return power * std::tgamma(2.0 - g);
  }
  std::abort();
}

}  // namespace fde
