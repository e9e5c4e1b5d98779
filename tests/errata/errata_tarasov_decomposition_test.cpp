// SPDX-License-Identifier: MIT
// Tarasov & Zaslavsky 2006, the decomposition of the one-dimensional example: eqs 52-54, as printed and
// corrected.

#include <gtest/gtest.h>

#include <numbers>

#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/caputo.hpp"

namespace fde::bench {
namespace {

// The part f of eq. 53 that decays like a power, by quadrature, and the oscillating part g.
double f(double nu, int k, double t) {
  constexpr double pi = std::numbers::pi;
  const auto rest = [=](double r) {
    return std::exp(-r * t) / (std::pow(r, 2.0 * nu) + 2.0 * std::pow(r, nu) * std::cos(pi * nu) + 1.0);
  };
  const double power = nu - 1.0 - k;
  const auto whole = [&](double r) { return rest(r) * std::pow(r, power); };
  const double far = 50.0 / t;  // the integrand is below e^-50 beyond
  return (k == 0 ? 1.0 : -1.0) * std::sin(pi * nu) / pi *
         (integral(rest, 0.0, 0.5, power) + integral(whole, 0.5, far));
}
double oscillating_part(double nu, int k, double t) {
  const double angle = std::numbers::pi / nu;
  return 2.0 / nu * std::exp(t * std::cos(angle)) * std::cos(t * std::sin(angle) - angle * k);
}

TEST(ErrataTarasov, Equation52HasAFactorTTooMany) {
  for (const double nu : {1.2, 1.5, 1.8}) {
    const double t = 2.0, z = -std::pow(t, nu);
    EXPECT_NEAR(f(nu, 0, t) + oscillating_part(nu, 0, t), reference::mittag_leffler(nu, 1.0, z), 1e-12) << nu;
    EXPECT_NEAR(f(nu, 1, t) + oscillating_part(nu, 1, t), t * reference::mittag_leffler(nu, 2.0, z), 1e-12)
        << nu;
  }
  EXPECT_NEAR(f(1.5, 1, 2.0) + oscillating_part(1.5, 1, 2.0), 0.829939692024598, 1e-12);
  EXPECT_NEAR(2.0 * (f(1.5, 1, 2.0) + oscillating_part(1.5, 1, 2.0)), 1.6598793840492, 1e-12);
}

TEST(ErrataTarasov, Equation52HoldsForOmegaOneOnly) {
  const double nu = 1.5, w2 = 4.0, t = 2.0, scaled = std::pow(w2, 1.0 / nu) * t;
  const double exact = reference::mittag_leffler(nu, 1.0, -w2 * std::pow(t, nu));
  EXPECT_NEAR(exact, -0.0599491843836891, 1e-14);
  EXPECT_NEAR(f(nu, 0, t) + oscillating_part(nu, 0, t), -0.149363895024064, 1e-12);
  EXPECT_NEAR(f(nu, 0, scaled) + oscillating_part(nu, 0, scaled), exact, 1e-12);
  EXPECT_NEAR((f(nu, 1, scaled) + oscillating_part(nu, 1, scaled)) * std::pow(w2, -1.0 / nu),
              t * reference::mittag_leffler(nu, 2.0, -w2 * std::pow(t, nu)), 1e-12);
}

// With alpha as printed, 2 < alpha < 3, it is the wrong function and g grows; for orders below 1 there is no
// g.
TEST(ErrataTarasov, Equation53HoldsForTheOrderAlphaMinusOne) {
  const double t = 2.0, printed = f(2.5, 0, t) + oscillating_part(2.5, 0, t);
  EXPECT_NEAR(printed, reference::mittag_leffler(2.5, 1.0, -std::pow(t, 2.5)), 1e-12);
  EXPECT_NEAR(printed, -0.448106490585671, 1e-12);
  EXPECT_NEAR(reference::mittag_leffler(1.5, 1.0, -std::pow(t, 1.5)), -0.149363895024064, 1e-14);
  EXPECT_GT(std::cos(std::numbers::pi / 2.5), 0.3);
  EXPECT_LT(std::cos(std::numbers::pi / 1.5), 0.0);
  EXPECT_NEAR(f(0.5, 0, t), reference::mittag_leffler(0.5, 1.0, -std::sqrt(t)), 1e-12);
  EXPECT_NEAR(f(0.5, 0, t), 0.336204002446341, 1e-12);
  EXPECT_GT(f(0.5, 0, t) + oscillating_part(0.5, 0, t), 29.0);
}

// The solution of D^(3/2) q + q = 1 with q(0) = 1, q'(0) = 0 is 1, not E_{3/2}(-t^(3/2)).
TEST(ErrataTarasov, Equation54HoldsWithoutItsMiddleMember) {
  const double nu = 1.5, t = 2.0, e = reference::mittag_leffler(nu, 1.0, -std::pow(t, nu));
  const reference::Reference solution = reference::linear_reference(
      reference::LinearEquation{{{1.0, nu}, {1.0, 0.0}}, {1.0, 0.0}, {{1.0}}}, {0.0});
  EXPECT_NEAR(solution.at(t).value[0], 1.0, 1e-14);
  EXPECT_NEAR(e, -0.149363895024064, 1e-14);
  const auto kernel = [&](double s) { return reference::mittag_leffler(nu, nu, -std::pow(s, nu)); };
  EXPECT_NEAR(f(nu, 0, t) + oscillating_part(nu, 0, t) + integral(kernel, 0.0, t, nu - 1.0), 1.0, 1e-12);
}

}  // namespace
}  // namespace fde::bench
