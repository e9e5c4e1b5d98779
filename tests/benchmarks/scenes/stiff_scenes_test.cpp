// SPDX-License-Identifier: MIT
// The reference of the stiff scenes, against independent values.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

reference::ReferenceValue computed_at(std::string_view scene, const ParameterValues& values, double t) {
  Scene made = scene_of(scene, values);
  made.name.clear();  // computed here, whatever is in the cache
  made.problem.end = t;
  return reference_of(made).at(t);
}

// E_g(z) = -sum_k z^-k / Gamma(1 - g k): the first two terms, the second with 1/Gamma(0) = 0 for g = 1/2.
TEST(StiffRelaxation, CreepsLikeItsAsymptoticSeries) {
  for (const double lambda : {-1e2, -1e4, -1e6, -1e8}) {
    const double first = -1.0 / (lambda * std::sqrt(std::numbers::pi));
    const double third = 1.0 / (2.0 * std::pow(lambda, 3) * std::sqrt(std::numbers::pi));  // Gamma(-1/2)
    const reference::ReferenceValue known = computed_at("stiff_relaxation", {{"lambda", lambda}}, 1.0);
    EXPECT_NEAR(known.value[0] / (first + third), 1.0, 2.0 * std::pow(lambda, -4) + 1e-15) << lambda;
    EXPECT_LT(known.bound[0], 1e-15 * first);
  }
}

// A hundredth inside and outside of the sector's edge: E_(1/2)(z) = exp(z^2) erfc(-z), which is 2 exp(z^2)
// outside, where u grows, and -1 / (z sqrt(pi)) inside.
TEST(StiffRelaxation, IsRightOnBothSidesOfTheSectorsEdge) {
  constexpr double size = 1e6, edge = std::numbers::pi / 4;
  const auto at = [&](std::complex<double> rate, double t) {
    const reference::ReferenceValue reference =
        computed_at("stiff_relaxation", {{"lambda", rate.real()}, {"im", rate.imag()}}, t);
    return std::complex(reference.value[0], reference.value[1]);
  };
  const auto inside = std::polar(size, edge + 0.01), outside = std::polar(size, edge - 0.01);
  const auto creeping = -1.0 / (inside * std::sqrt(std::numbers::pi));
  EXPECT_LT(std::abs(at(inside, 1.0) / creeping - 1.0), 1e-11);
  constexpr double t = 1e-9;
  EXPECT_LT(std::abs(at(outside, t) / (2.0 * std::exp(outside * outside * t)) - 1.0), 1e-10);
}

// As printed with LSODE (Hindmarsh 1980), to the digits that all codes agree on.
TEST(Robertson, HasThePublishedValuesForOrderOne) {
  const reference::ReferenceValue known = computed_at("robertson", {{"gamma", 1.0}}, 40.0);
  EXPECT_NEAR(known.value[0], 0.7158271, 5e-8);
  EXPECT_NEAR(known.value[1], 9.185535e-6, 5e-13);
  EXPECT_NEAR(known.value[2], 0.2841637, 5e-8);
}

TEST(Robertson, LosesNothing) {
  for (const double gamma : {0.1, 0.5, 0.9}) {
    for (const double t : {1.0, 1e3, 1e5}) {
      const reference::ReferenceValue known = computed_at("robertson", {{"gamma", gamma}}, t);
      EXPECT_NEAR(known.value.sum(), 1.0, known.bound.sum()) << gamma << " " << t;
      EXPECT_LT(known.bound.maxCoeff(), 1e-11);
      EXPECT_GT(known.value.minCoeff(), 0.0);
    }
  }
}

TEST(VanDerPol, HasThePublishedPeriodForOrderOne) {
  constexpr double period = 6.66328685933;  // Andersen & Geer, SIAM J. Appl. Math. 42 (1982) 678
  const reference::ReferenceValue early = computed_at("van_der_pol", {{"gamma", 1.0}}, 60.0);
  const reference::ReferenceValue late = computed_at("van_der_pol", {{"gamma", 1.0}}, 60.0 + period);
  EXPECT_NEAR(early.value[0], late.value[0], 1e-9);
  EXPECT_NEAR(early.value[1], late.value[1], 1e-9);
}

// In the slow phase x determines v: mu (1 - x^2) v = x + D^g v. The largest part of D^g v is the memory of
// the initial change of v from v(0) = 0 to about its present value, v t^-g / Gamma(1-g).
TEST(VanDerPol, CreepsForEveryStiffness) {
  constexpr double gamma = 0.9, t = 5.0;
  for (const double mu : {10.0, 1e2, 1e3, 1e4, 1e6}) {
    const reference::ReferenceValue known = computed_at("van_der_pol", {{"mu", mu}}, t);
    const double x = known.value[0], v = known.value[1];
    const double remembered = v * std::pow(t, -gamma) / std::tgamma(1.0 - gamma);
    EXPECT_NEAR(v * mu * (1.0 - x * x) / (x + remembered), 1.0, 2.0 / (mu * mu) - known.bound[1] / v) << mu;
    EXPECT_LT(known.bound.maxCoeff(), 1e-12);
  }
}

}  // namespace
}  // namespace fde::bench
