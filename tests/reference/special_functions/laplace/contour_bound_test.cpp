// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/contour_bound.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/reference/special_functions/laplace/contour.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

namespace fde::reference {
namespace {

struct ContourCase {
  const char* name;
  double alpha, beta;
  std::complex<double> z;
};

class OnCoarseContours : public testing::TestWithParam<ContourCase> {
 protected:
  using Roots = std::vector<std::complex<double>>;

  // 1 + i theta of the poles with |arg s*| < 2 pi.
  [[nodiscard]] static Roots roots_of(const ContourCase& x, double mu, double& nearest_other_argument) {
    Roots roots;
    for (int sheet = -6; sheet <= 6; ++sheet) {
      const double argument = std::arg(x.z) + 2.0 * sheet * std::numbers::pi;
      if (std::abs(argument) < 2.0 * std::numbers::pi * x.alpha) {
        const std::complex<double> log(std::log(std::abs(x.z)), argument);
        roots.push_back(std::exp((log / x.alpha - std::log(mu)) / 2.0));
      } else {
        nearest_other_argument = std::min(nearest_other_argument, std::abs(argument));
      }
    }
    return roots;
  }
};

// The trapezoidal sum with its residues at 60 digits, so that its error is the discretisation error.
BigComplex sum_with_residues(const ContourCase& x, const Contour<BigReal>& contour,
                             const std::vector<std::complex<double>>& roots, double distance) {
  const BigReal alpha(x.alpha), beta(x.beta);
  const BigComplex z(x.z.real(), x.z.imag());
  BigComplex sum(0);
  const auto transform = [&](const BigComplex& log_s) {
    return BigComplex(exp(BigComplex((alpha - beta) * log_s)) / (exp(BigComplex(alpha * log_s)) - z));
  };
  for (const auto& node : contour.nodes())
    sum += node.weight * transform(node.log_s) + conj(node.weight) * transform(conj(node.log_s));
  for (const auto& root : roots) {
    if (!ContourBound::includes_residue(root, distance)) continue;
    const double sheet =
        std::round((std::arg(root) * 2.0 * x.alpha - std::arg(x.z)) / (2.0 * std::numbers::pi));
    const BigComplex log_pole = (log(z) + BigComplex(0, 2 * sheet * pi<BigReal>())) / alpha;
    sum += exp(BigComplex(exp(log_pole) + (1 - beta) * log_pole)) / alpha * contour.pole_factor(log_pole);
  }
  return sum;
}

TEST_P(OnCoarseContours, WhatIsNeglectedIsBounded) {
  const ContourCase& x = GetParam();
  const auto text = [](double number) { return fmt::format("{}", number); };
  const auto exact = mittag_leffler(text(x.alpha), text(x.beta), text(x.z.real()), text(x.z.imag()), 45);
  for (const double omega : {16.0, 24.0, 40.0, 64.0}) {
    for (const bool shifted : {false, true}) {
      const ContourShape shape{.mu = omega / 8.3, .omega = omega, .depth = omega, .half_step_shift = shifted};
      ContourBound::Quotient quotient{.exponent = x.alpha - x.beta,
                                      .alpha = x.alpha,
                                      .log_size = std::log(std::abs(x.z)),
                                      .nearest_other_argument = 100.0,
                                      .roots = {}};
      const auto roots = roots_of(x, shape.mu, quotient.nearest_other_argument);
      quotient.roots = roots;
      const auto [log_bound, distance] = ContourBound(shape).bound_for(quotient);
      const Precision precision(60);
      const Contour<BigReal> contour(shape.mu, omega, omega, shifted);
      const BigComplex off =
          sum_with_residues(x, contour, roots, distance) - BigComplex(BigReal(exact.re), BigReal(exact.im));
      EXPECT_LE(log(norm1(off)).convert_to<double>(), log_bound + std::numbers::ln2)
          << "omega = " << omega << (shifted ? ", shifted" : "");
    }
  }
}

// The function is the integral along a line plus the residues of the poles to the right of it.
TEST_P(OnCoarseContours, TheIntegralAlongALineIsBounded) {
  constexpr double rounding = 1e-13;  // of large residues
  const ContourCase& x = GetParam();
  const std::complex<double> value = mittag_leffler(x.alpha, x.beta, x.z).value;
  for (const double mu : {0.5, 2.0, 8.0}) {
    for (const double distance : {0.25, 1.0, 2.0}) {
      ContourBound::Quotient quotient{.exponent = x.alpha - x.beta,
                                      .alpha = x.alpha,
                                      .log_size = std::log(std::abs(x.z)),
                                      .nearest_other_argument = 100.0,
                                      .roots = {}};
      const auto roots = roots_of(x, mu, quotient.nearest_other_argument);
      quotient.roots = roots;
      std::complex<double> integral = value;
      for (const auto& root : roots) {
        const std::complex<double> pole = mu * root * root, log_pole = std::log(mu) + 2.0 * std::log(root);
        if (root.real() > distance) integral -= std::exp(pole + (1.0 - x.beta) * log_pole) / x.alpha;
      }
      EXPECT_LE(std::abs(integral),
                std::exp(ContourBound::log_integral(mu, distance, quotient)) + rounding * std::abs(value))
          << "mu = " << mu << ", distance " << distance;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    ContourBound, OnCoarseContours,
    testing::Values(
        ContourCase{"NoPole", 0.5, 1.0, -1.0}, ContourCase{"Kernel", 0.5, 0.5, -3.0},
        ContourCase{"SmallArgument", 0.75, 1.0, 0.015625}, ContourCase{"LargeArgument", 0.75, 1.0, -1024.0},
        ContourCase{"PoleOnTheRealAxis", 0.5, 1.0, 1.5}, ContourCase{"PoleBeyondTheContour", 0.5, 1.0, 6.0},
        ContourCase{"PoleNextToTheCut", 1.0078125, 1.0, -5.0}, ContourCase{"PairOfPoles", 1.5, 1.0, -20.0},
        ContourCase{"ThreePairs", 4.5, 2.0, -100.0}, ContourCase{"ComplexArgument", 0.75, 1.5, {-2.0, 3.0}},
        ContourCase{"SmallOrder", 0.0625, 1.0, {0.5, 0.5}}, ContourCase{"NegativeBeta", 0.75, -3.25, -2.0},
        ContourCase{"LargeBeta", 1.25, 9.5, -2.0}),
    [](const testing::TestParamInfo<ContourCase>& test) { return test.param.name; });

// The logarithm of a line integral is convex in the exponent, and so lies below its chords.
TEST(LineIntegrals, InterpolationIsAnUpperBound) {
  for (const double distance : {0.02, 0.3, 4.0}) {
    const LineIntegrals table(7.0, distance);
    for (double exponent = -10.0; exponent <= 10.0; exponent += 0.37) {
      // Midpoint rule on the integral itself, far finer than needed.
      long double integral = 0.0L;
      constexpr long double step = 0.01L;
      for (long double x = step / 2; x < 6.0L; x += step) {
        const long double square = distance * distance, modulus = 7.0L * (square + x * x);
        integral += 2.0L * step * 7.0L / std::numbers::pi_v<long double> * std::exp(7.0L * (square - x * x)) *
                    std::sqrt(square + x * x) * std::pow(modulus, static_cast<long double>(exponent));
      }
      EXPECT_GE(table.log_at(exponent), static_cast<double>(std::log(integral)) - 1e-6)
          << "distance " << distance << ", exponent " << exponent;
    }
  }
}

}  // namespace
}  // namespace fde::reference
