// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fdebench/reference/special_functions/mittag_leffler/contour_kernels.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/multiprecision.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/quick.hpp"
#include "fdebench/schemes/history/block_kernels.hpp"

namespace fde::reference {
namespace {

using Value = std::complex<double>;

struct Point {
  double alpha, beta;
  Value z;
};

// One point for each branch of the code: no pole, poles left and right, peeled terms, other contours, no
// branch cut, 1/Gamma(beta) = 0, nearly integer orders.
const std::vector<Point> points{{0.5, 1.0, -1.0},
                                {0.25, 0.25, -40.0},
                                {0.75, 0.75, -1e7},
                                {0.015625, 1.0, -1e4},
                                {0.5, 1.0, 2.5},
                                {0.75, 1.0, Value(-2.0, 3.0)},
                                {0.75, 1.0, std::polar(30.0, 0.375 * std::numbers::pi)},
                                {1.0 + 0x1p-40, 1.0, -30.0},
                                {1.0 - 0x1p-40, 1.0, -300.0},
                                {1.5, 1.0, -25.0},
                                {1.9990234375, 1.0, -1e4},
                                {2.5, 1.5, -1e3},
                                {4.75, 3.0, Value(1e3, 1e3)},
                                {0.75, -4.25, -2.0},
                                {0.75, 18.5, -2.0},
                                {0.75, 45.0, -2.0},
                                {0.75, -2.0, -2.0},
                                {1.0, 1.0, Value(-3.0, 4.0)},
                                {3.0, 2.0, -50.0},
                                {2.0, 1.0, 1e4},
                                {0.5, 1.0, -1e-30},
                                {0.5, 0.0, -1e300},
                                {0.5, 1e-30, Value(1e-31, 2e-31)},
                                {0x1p-40, 1e-20, -1e-12},
                                {4.5, -1e-25, -1e-10}};

std::string name_of(const Point& x) {
  return fmt::format("E_{{{},{}}}({}{:+}i)", x.alpha, x.beta, x.z.real(), x.z.imag());
}

// The value to 40 digits.
Bounded<BigReal> exact_value(const Point& x) {
  const Precision precision(60);
  return mittag_leffler_multiprecision(40, 60, [&] {
    return MittagLefflerArguments{BigReal(x.alpha), BigReal(x.beta), BigComplex(x.z.real(), x.z.imag())};
  });
}

double error_over_bound(const Bounded<BigReal>& exact, const QuickValue& quick) {
  const Precision precision(60);
  const BigReal re = real_part<BigReal>(exact.value) - BigReal(quick.value.real());
  const BigReal im = imag_part<BigReal>(exact.value) - BigReal(quick.value.imag());
  return BigReal((abs(re) + abs(im)) / (BigReal(quick.error) + exact.bound)).convert_to<double>();
}

TEST(MittagLefflerQuick, IsWithinItsBoundOnEveryVectorTarget) {
  for (const Point& x : points) {
    const auto exact = exact_value(x);
    for (const auto& target : vector_targets()) {
      select_vector_target(target);
      const auto quick = mittag_leffler_quick(x.alpha, {x.beta, 0.0}, x.z);
      ASSERT_TRUE(quick) << name_of(x);
      EXPECT_LE(error_over_bound(exact, *quick), 1.0) << name_of(x) << " on " << target;
      EXPECT_LE(quick->error, quick_tolerance * std::abs(quick->value)) << name_of(x) << " on " << target;
    }
  }
  select_vector_target(vector_targets().front());
}

TEST(MittagLefflerQuick, IsNotThereWhereThePhaseOfAPoleIsUnknown) {
  EXPECT_FALSE(mittag_leffler_quick(0.5, {1.0, 0.0}, std::polar(1e20, 0.25 * std::numbers::pi)));
  EXPECT_FALSE(mittag_leffler_quick(0.5, {100.0, 0.0}, -1.0));
}

// Tiny orders next to the zeros of 1/Gamma: power series for |z| < 1, otherwise
// -sum z^-k / Gamma(beta - alpha k), in mpmath with 420 digits.
TEST(MittagLefflerQuick, TakesTinyOrdersNextToTheZerosOfTheReciprocalGammaFunction) {
  struct KnownCase {
    double alpha, beta;
    Value z, value;
  };
  for (const auto& [alpha, beta, z, value] :
       {KnownCase{1e-40, -3.0, 0.5, -1.1999999999999999e-39},
        KnownCase{1e-300, 0.0, -2.0, -2.2222222222222223e-301},
        KnownCase{1e-31, -20.0, -3.0, -4.5616912653312004e-14},
        KnownCase{1e-40, 1e-50, 0.5, 2.0000000001999999e-40},
        KnownCase{1e-310, -150.0, -1.5, -1.3712121495470009e-48},
        KnownCase{1e-40, -1.0, {3.0, 4.0}, {-6.9999999999999995e-42, 2.3999999999999998e-41}},
        KnownCase{1e-32, 3e-33, {-0.5, 0.25}, {-4.4996347699050404e-34, 6.4572680788897009e-34}},
        KnownCase{1e-200, -2.0, {1e20, 1e-3}, {2e-220, -2e-243}}}) {
    const auto quick = mittag_leffler_quick(alpha, {beta, 0.0}, z);
    ASSERT_TRUE(quick) << alpha << ' ' << beta;
    EXPECT_LE(quick->error, quick_tolerance * std::abs(quick->value)) << alpha << ' ' << beta;
    const auto [found, bound] = mittag_leffler(alpha, beta, z);
    EXPECT_LE(std::abs(found - value), bound + 2e-16 * std::abs(value)) << alpha << ' ' << beta;
    EXPECT_NEAR(found.imag(), value.imag(), 1e-15 * std::abs(value.imag())) << alpha << ' ' << beta;
  }
}

TEST(ComplexLogarithm, HasThirtyDigits) {
  std::mt19937_64 random(
      11);  // NOLINT(bugprone-random-generator-seed,cert-msc51-cpp): the same points each time
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  std::vector<Value> arguments{1.5, -1.0, Value(0.0, 2.0), Value(1.0, 1e-20)};
  for (int i = 0; i < 500; ++i) arguments.emplace_back(uniform(random), uniform(random));
  const Precision precision(50);
  for (const Value z : arguments) {
    const auto log_z = complex_logarithm(z);
    const BigComplex exact = log(BigComplex(z.real(), z.imag()));
    const BigReal re = real_part<BigReal>(exact) - log_z.re.hi - log_z.re.lo;
    const BigReal im = imag_part<BigReal>(exact) - log_z.im.hi - log_z.im.lo;
    EXPECT_LE(abs(re), BigReal(0x1p-101)) << z;
    EXPECT_LE(abs(im), BigReal(0x1p-101)) << z;
  }
}

// E changes sign between `from` and `to`. At the zero the bound is 8 ulp of |z E'|, and a little farther off
// 8 ulp of |E| again.
struct Bracket {
  double alpha, beta, from, to;
};

class NearZero : public testing::TestWithParam<Bracket> {};

TEST_P(NearZero, KeepsItsAccuracy) {
  auto [alpha, beta, low, high] = GetParam();
  const auto at = [a = alpha, b = beta](double z) { return mittag_leffler(a, b, z); };
  ASSERT_LT(at(low) * at(high), 0.0);
  while (std::nextafter(low, high) < high) {
    const double middle = (low + high) / 2.0;
    (at(middle) * at(low) > 0.0 ? low : high) = middle;
  }
  const double slope = (at(low + 0.01) - at(low - 0.01)) / 0.02;
  EXPECT_LE(mittag_leffler(alpha, beta, Value(low)).bound, 8 * 0x1p-53 * std::abs(low * slope));
  const auto [value, bound] = mittag_leffler(alpha, beta, Value(low * (1.0 + 1e-6)));
  EXPECT_LE(bound, 8 * 0x1p-53 * std::abs(value));
}

INSTANTIATE_TEST_SUITE_P(MittagLeffler, NearZero,
                         testing::Values(Bracket{1.5, 1.0, -2.5, -2.0}, Bracket{1.5, 1.0, -15.0, -12.0},
                                         Bracket{1.75, 1.75, -10.0, -6.0}, Bracket{2.0, 1.0, -3.0, -2.0},
                                         Bracket{1.999, 1.0, -1e4, -9.4e3}),
                         [](const auto& test) { return std::to_string(test.index); });

}  // namespace
}  // namespace fde::reference
