// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"

#include <fmt/format.h>
#include <gsl/gsl_sf_gamma.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <stdexcept>

#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar_quick.hpp"
#include "support/testing.hpp"

namespace fde::reference {
namespace {

using Value = std::complex<double>;
using Precise = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>,
                                              boost::multiprecision::et_off>;

// |a - b| is within the bounds of both, and a.bound is below 1e-15 relative.
void expect_same(const MittagLefflerValue& a, Value b, double bound, const std::string& name) {
  EXPECT_LE(std::abs(a.value - b), a.bound + bound) << name << ": " << a.value << " for " << b;
  EXPECT_LE(a.bound, 1e-15 * std::abs(a.value)) << name;
}

Precise decimal(double x) { return Precise(fmt::format("{:.12g}", x)); }

struct KnownPrabhakar {
  double alpha, beta, gamma;
  Value z, value;
};

std::string name_of(double alpha, double beta, double gamma, Value z) {
  return fmt::format("E^{}_{{{},{}}}({}{:+}i)", gamma, alpha, beta, z.real(), z.imag());
}

// mpmath 1.3: the power series at 60 digits plus the number of digits of its largest term.
const std::vector<KnownPrabhakar> prabhakar_by_power_series{
    {0.7, 1.0, 1.5, -3.0, 0.02218924634849091735},
    {0.7, 1.0, 1.5, {-3.0, 4.0}, {-0.0081601223865187107174, -0.00050076425239855378033}},
    {0.3, 0.3, 2.5, {0.5, 1.0}, {0.1267282342141331212, -1.0998070644639930879}},
    {1.5, 0.5, 0.5, {-60.0, 25.0}, {-0.032242434168827447143, -0.0045354175886105280418}},
    {1.8, 1.0, 1.7, -80.0, 0.59608262159786428994},
    {0.9, -1.0, -0.5, 5.0, -219.03393480106469394},
    {2.5, 1.0, 2.25, -500.0, 228.95012569513855218},
    {0.5, 0.0, 1.5, {-0.25, 0.125}, {-0.13571158979874840029, 0.029506601216077424355}},
    {0.125, 1.0, 1.5, -1.125, 0.30345728190908344947},
    {1.25, -2.0, 3.0, {-20.0, 30.0}, {27261.350282149425833, 7912.263399490478021}},
    {3.0, 1.5, 1.5, -400.0, 18.231945005130271268},
    {2.0, 1.0, 0.5, -150.0, 0.10041906079022948454},
    {1.5, 1.0, 1.5, {-250.0, 650.0}, {9568115781.4335242888, 9400116172.688917854}},
    {1.3, 1.0, 2.7, {-250.0, 250.0}, {-1.1137564810500022146e-7, -2.383286326721174557e-7}},
    {4.5, 2.0, 1.5, 1e4, 111.51152309484032684}};

TEST(Prabhakar, MeetsValuesFromAnIndependentSummation) {
  for (const auto& [alpha, beta, gamma, z, value] : prabhakar_by_power_series) {
    expect_same(prabhakar(alpha, beta, gamma, z), value, 2e-16 * std::abs(value),
                name_of(alpha, beta, gamma, z));
  }
}

// mpmath 1.3: the power series at 200 digits. One point for each case of the contours in double-double: no
// singularity on the sheet, one of large imaginary part inside, one on the positive axis, one so far to the
// left that it is negligible.
const std::vector<KnownPrabhakar> on_a_contour{
    {0.75, 1, 1.5, -20.0, -0.0011599938916278277578},
    {0.5, 0.5, 0.25, -3.0, 0.32428117250747484299},
    {1.5, 1, 1.5, -100.0, 0.00034750430056852317827},
    {1.875, 1, 2.75, -400.0, -1.3726405048721079301},
    {1.75, 0.75, 0.5, -600.0, -0.0046338479627974778789},
    {1.25, 1, 1.5, -700.0, -6.2386955398091130819e-6},
    {1.25, 1.5, 2.5, {-60.0, -25.0}, {7.880724139459679743e-6, -0.000010926006175760974673}},
    {0.875, 1, 1.25, 4.5, 534.70362093002372891},
    {2, 1, 1.5, -900.0, 3.4761638949176478843},
    {0.625, -1.5, 3.25, {-2.0, 7.0}, {-0.0016586723223759628514, -0.015708421565897785081}},
    {2.5, 1, 0.5, -300.0, -3.4689008379861016369},
    {1.125, 1, 0.75, {-300.0, 40.0}, {0.0023024956235531178988, 0.0002297908287451892208}}};

TEST(PrabhakarOnContour, MeetsValuesFromAnIndependentSummation) {
  for (const auto& [alpha, beta, gamma, z, value] : on_a_contour) {
    const std::string name = name_of(alpha, beta, gamma, z);
    const bool mirrored = z.imag() < 0.0;
    const auto known = prabhakar_on_contour(alpha, {beta, 0.0}, gamma, mirrored ? std::conj(z) : z);
    ASSERT_TRUE(known) << name;
    const auto upper = mirrored ? std::conj(value) : value;
    const double off = std::abs(std::complex<double>(known->value) - upper);
    EXPECT_LE(off, static_cast<double>(known->error) + 2e-16 * std::abs(value)) << name;
    EXPECT_LE(known->error, quick_tolerance * std::abs(known->value)) << name;
    expect_same(prabhakar(alpha, beta, gamma, z), value, 2e-16 * std::abs(value), name);
  }
}

// mpmath 1.3, as above: beyond max_quick_derivative, and at a small z.
TEST(MittagLefflerDerivative, OfHighOrderMeetsAnIndependentSummation) {
  struct Row {
    int k;
    double alpha, beta, z, value;
  };
  for (const auto& [k, alpha, beta, z, value] :
       {Row{4, 0.5, 1.0, -0.5, 2.9800877667725085589}, Row{12, 0.75, 1.0, -2.5, 5.4304878370561937991},
        Row{20, 1.5, 0.5, -6.0, 2.3926940315212387608e-14},
        Row{6, 0.875, 1e-12, 0.625, 57.545601167585971088}}) {
    expect_same(mittag_leffler_derivative(k, alpha, beta, z), value, 2e-16 * std::abs(value),
                fmt::format("k = {}, z = {}", k, z));
  }
}

// The value is 1/Gamma(beta), and beta is far below the last digit of alpha.
TEST(Prabhakar, KeepsASmallSecondParameter) {
  EXPECT_DOUBLE_EQ(prabhakar(0.7, 1e-30, 4.0, 0.0).value.real(), 1e-30);
}

// mpmath 1.3: hyp1f1(gamma, beta, z) / gamma(beta) at 30 digits.
TEST(Prabhakar, OfOrderOneIsKummersFunction) {
  const std::vector<KnownPrabhakar> rows{
      {1.0, 1.5, 0.5, -3.0, 0.56909076642393639986},
      {1.0, 0.5, 1.75, -12.5, 0.0046604294995437893515},
      {1.0, 3.25, 2.5, 4.0, 10.966470185051593351},
      {1.0, 2.0, 0.25, {-3.0, 5.0}, {0.67153161300639453739, 0.15687531422187589883}},
      {1.0, 1.25, -0.75, {2.0, -8.0}, {1.4023288874665867545, 4.544584149441502787}}};
  for (const auto& [alpha, beta, gamma, z, value] : rows) {
    expect_same(prabhakar(alpha, beta, gamma, z), value, 2e-16 * std::abs(value),
                name_of(alpha, beta, gamma, z));
  }
}

struct Place {
  double alpha, beta;
  Value z;
};

const std::vector<Place> places{{0.5, 1.0, -2.0},          {0.9, 0.9, {-7.0, 3.0}}, {0.25, 1.0, {0.6, 0.9}},
                                {1.0, 1.0, {-30.0, -4.0}}, {1.5, 2.0, -40.0},       {1.9, 0.0, {-100.0, 1.0}},
                                {2.0, 1.0, -64.0},         {2.75, -1.0, 200.0},     {5.0, 4.5, {-1e4, 1e4}},
                                {0.7, 1.0, -1e12},         {0.7, 0.7, -1e-9},       {0.05, 1.0, -1.5}};

TEST(Prabhakar, OfExponentOneIsTheMittagLefflerFunction) {
  for (const auto& [alpha, beta, z] : places) {
    const auto known = mittag_leffler(alpha, beta, z);
    expect_same(prabhakar(alpha, beta, 1.0, z), known.value, known.bound, name_of(alpha, beta, 1.0, z));
  }
}

// alpha z E' = E_{alpha,beta-1} - (beta - 1) E_{alpha,beta}, to 40 digits, relative to the terms.
TEST(MittagLefflerDerivative, ObeysItsDifferentialRelation) {
  for (const auto& [alpha, beta, z] : places) {
    const auto text = [](double x) { return fmt::format("{:.12g}", x); };  // 0.9 - 1 is -0.1
    const auto derivative = [&, a = alpha, x = z](int k, double b) {
      return mittag_leffler_derivative(k, text(a), text(b), text(x.real()), text(x.imag()), 40);
    };
    const auto slope = derivative(1, beta), own = derivative(0, beta), below = derivative(0, beta - 1.0);
    const Precise left =
        decimal(alpha) * (decimal(z.real()) * Precise(slope.re) - decimal(z.imag()) * Precise(slope.im));
    const Precise first(below.re), second = decimal(beta - 1.0) * Precise(own.re);
    EXPECT_LE(abs(Precise(left - first + second)), 1e-38 * (abs(left) + abs(first) + abs(second)))
        << name_of(alpha, beta, 1.0, z);
  }
}

TEST(MittagLefflerDerivative, OfTheExponentialIsTheExponential) {
  for (const int k : {0, 1, 2, 7, 25}) {
    for (const double x : {-20.0, -1.0, 0.25, 3.0}) {
      expect_same(mittag_leffler_derivative(k, 1.0, 1.0, x), std::exp(x), 2e-16 * std::exp(x),
                  fmt::format("k = {}, x = {}", k, x));
    }
  }
}

// d/dz cos sqrt(-z) = sin(x) / (2 x) and its derivative (sin x - x cos x) / (4 x^3), z = -x^2.
TEST(MittagLefflerDerivative, OfTheCosineIsElementary) {
  for (const double x : {0.5, 2.0, 7.5, 20.0}) {
    const double first = std::sin(x) / (2.0 * x),
                 second = (std::sin(x) - x * std::cos(x)) / (4.0 * x * x * x);
    expect_same(mittag_leffler_derivative(1, 2.0, 1.0, -x * x), first, 4e-16 * std::abs(first),
                fmt::format("x = {}", x));
    expect_same(mittag_leffler_derivative(2, 2.0, 1.0, -x * x), second, 4e-16 / (x * x),
                fmt::format("x = {}", x));
  }
}

TEST(MittagLefflerDerivative, AtZeroIsACoefficientOfTheSeries) {
  for (const int k : {0, 1, 5, 20}) {
    const double exact = gsl_sf_fact(static_cast<unsigned>(k)) / std::tgamma(0.75 * k + 1.25);
    expect_same(mittag_leffler_derivative(k, 0.75, 1.25, 0.0), exact, 1e-14 * exact,
                fmt::format("k = {}", k));
  }
}

TEST(Prabhakar, OfANegativeWholeExponentIsAPolynomial) {
  const Value z(3.0, -1.5);
  const double b = 1.25, a = 0.5;
  const Value linear = 1.0 / std::tgamma(b) - z / std::tgamma(a + b);
  const Value quadratic =
      1.0 / std::tgamma(b) - 2.0 * z / std::tgamma(a + b) + z * z / std::tgamma(2.0 * a + b);
  expect_same(prabhakar(a, b, -1.0, z), linear, 1e-14, "linear");
  expect_same(prabhakar(a, b, -2.0, z), quadratic, 1e-14, "quadratic");
  expect_same(prabhakar(a, b, 0.0, z), 1.0 / std::tgamma(b), 1e-15, "constant");
}

// The leading term is (-z)^-gamma / Gamma(beta - alpha gamma); where that vanishes,
// (-z)^-gamma gamma / (z Gamma(-alpha)).
TEST(Prabhakar, FallsOffAlgebraically) {
  const double z = -0x1p200;
  for (const double gamma : {0.5, 1.5, 2.0}) {
    const double leading = std::pow(-z, -gamma) / std::tgamma(1.0 - 0.75 * gamma);
    expect_same(prabhakar(0.75, 1.0, gamma, z), leading, 4e-15 * std::abs(leading),
                fmt::format("gamma = {}", gamma));
    const double next = std::pow(-z, -gamma) * gamma / (z * std::tgamma(-0.75));
    expect_same(prabhakar(0.75, 0.75 * gamma, gamma, z), next, 4e-15 * std::abs(next),
                fmt::format("gamma = {}", gamma));
  }
}

// Large positive and negative beta. For 120 the first two terms of the series dominate; -99.5 is compared at
// 60 digits.
TEST(Prabhakar, TakesLargeBeta) {
  const double leading = 1.0 / std::tgamma(120.0), next = 1.5 * 2.0 / std::tgamma(124.0);
  expect_same(prabhakar(4.0, 120.0, 1.5, 2.0), leading + next, 1e-14 * leading, "beta = 120");
  const auto below = prabhakar("0.5", "-99.5", "2", "-3", "0", 20),
             series = prabhakar("0.5", "-99.5", "2", "-3", "0", 60);
  EXPECT_LE(abs(Precise(Precise(below.re) - Precise(series.re))), Precise(below.bound));
  EXPECT_LE(Precise(below.bound), 1e-18 * abs(Precise(below.re)));
}

// Bounds hold against 30 more digits; the arguments are doubles with short decimals.
TEST(Prabhakar, BoundsItsError) {
  for (const int digits : {5, 20, 60}) {
    const auto few = prabhakar("1.1", "0.6", "1.3", "-21", "16", digits);
    const auto many = prabhakar("1.1", "0.6", "1.3", "-21", "16", digits + 30);
    EXPECT_LE(
        abs(Precise(Precise(few.re) - Precise(many.re))) + abs(Precise(Precise(few.im) - Precise(many.im))),
        Precise(few.bound));
    EXPECT_LE(Precise(few.bound), pow(Precise(10), 1 - digits) * abs(Precise(many.re)));
  }
}

BigReal bessel(BigReal value, long order) {
  mpfr_jn(value.backend().data(), order, BigReal(value).backend().data(), MPFR_RNDN);
  return value;
}

// Branch points at +-i a. From the transform (s^2 + a^2)^-1/2 of J_0(a t) (DLMF 10.22.49 with mu = 1, nu = 0)
// E^{1/2}_{2,1}(-a^2) = J_0(a); its derivative in t gives E^{1/2}_{2,0}(-a^2) = -a J_1(a), and
// alpha gamma E^{gamma+1}_beta = E^gamma_{beta-1} + (1 + alpha gamma - beta) E^gamma_beta the last one.
TEST(Prabhakar, FarFromTheRealAxisIsABesselFunction) {
  constexpr int digits = 30;
  const Precision precision(60);
  for (const int a : {200, 1000000}) {
    const std::string square = to_text(-BigReal(a) * a, 20);
    const BigReal first = bessel(BigReal(a), 0), second = -a * bessel(BigReal(a), 1);
    const auto expect = [&](const char* beta, const char* gamma, const BigReal& exact) {
      const DecimalComplex value = prabhakar("2", beta, gamma, square, "0", digits);
      EXPECT_LE(abs(BigReal(BigReal(value.re) - exact)), BigReal(value.bound)) << a << " " << beta;
      EXPECT_LE(BigReal(value.bound), pow(BigReal(10), 1 - digits) * abs(exact)) << a << " " << beta;
    };
    expect("1", "0.5", first);
    expect("0", "0.5", second);
    expect("1", "1.5", BigReal(first + second));
  }
}

// mpmath 1.3, as above.
TEST(Prabhakar, TakesDecimalsAtTheirWord) {
  EXPECT_EQ(prabhakar("0.7", "1", "1.5", "-3", "0", 49).re,
            "0.02218924634849090674171230883293524631421468329457");
}

// Texts longer than the requested digits, next to poles of Gamma and zeros of (gamma)_k.
TEST(Prabhakar, HoldsItsBoundForLongTexts) {
  const auto expect_held = [](const auto& evaluate, const char* name) {
    const DecimalComplex rough = evaluate(20), fine = evaluate(70);
    const Precise value(fine.re), off = abs(Precise(Precise(rough.re) - value));
    EXPECT_LE(off, Precise(rough.bound) + Precise(fine.bound)) << name;
    EXPECT_LE(Precise(rough.bound), abs(value) * Precise("1e-18")) << name;
  };
  expect_held(
      [](int n) {
        return mittag_leffler_derivative(0, "1.5", "-0.9999999999999999999999", "1e-200", "0", n);
      },
      "derivative");
  expect_held(
      [](int n) { return prabhakar("1.0", "-0.99999999999999999999999999999999", "-1", "0.3", "0", n); },
      "polynomial");
  expect_held(
      [](int n) { return prabhakar("1", "-1", "-0.999999999999999999999999999999", "0.125", "0", n); },
      "gamma");
  // 1/Gamma(0.1 k - 0.2) is 0 for k = 2
  const auto value = prabhakar("0.1", "-0.2", "-2", "0.5", "0", 30);
  const Precise exact = 1 / tgamma(Precise("-0.2")) - 1 / tgamma(Precise("-0.1"));
  EXPECT_LE(abs(Precise(Precise(value.re) - exact)), Precise(value.bound));
}

// The function is 1 - z, at z = 1.
TEST(Prabhakar, OfAZeroIsZeroWithASmallBound) {
  const auto zero = prabhakar("1", "1", "-1", "1", "0", 20);
  EXPECT_EQ(zero.re, "0");
  EXPECT_LE(Precise(zero.bound), Precise("1e-60"));
}

TEST(Prabhakar, SaysWhereDigitsRunOut) {
  bench::expect_message([] { prabhakar("0.5", "-2000.25", "1", "-1", "0", 2); },
                        "prabhakar(0.5, -2000.25, 1, z = -1 + 0 i): no accurate value in reach: bound ");
}

TEST(Prabhakar, SaysWhatIsWrong) {
  const double infinity = std::numeric_limits<double>::infinity();
  bench::expect_message([] { prabhakar(5.5, 1.0, 1.0, 1.0); }, "alpha = 5.5 has to be in (0, 5]");
  bench::expect_message([&] { prabhakar(0.5, infinity, 1.0, 1.0); },
                        "beta = inf has to be in [-10000, 10000]");
  bench::expect_message([&] { prabhakar(0.5, 1.0, infinity, 1.0); },
                        "gamma = inf has to be in [-10000, 10000]");
  bench::expect_message([&] { prabhakar(0.5, 1.0, 1.0, {0.0, infinity}); }, "z = 0 +inf i has to be finite");
  bench::expect_message([] { mittag_leffler_derivative(-1, 0.5, 1.0, 1.0); },
                        "k = -1 has to be in [0, 1000]");
  bench::expect_message([] { prabhakar("0.5", "x", "1", "1", "0", 10); },
                        "prabhakar: beta: 'x' is not a finite decimal number");
  bench::expect_message([] { mittag_leffler_derivative(1, "x", "1", "1", "0", 10); },
                        "mittag_leffler_derivative: alpha: 'x' is not a finite decimal number");
  bench::expect_message([] { prabhakar("0.5", "1", "1", "1", "0", 0); },
                        "digits = 0 has to be in [1, 100000]");
  EXPECT_THROW(prabhakar(0.5, 1.0, 1.5, 1e3), std::runtime_error);    // e^1000000
  EXPECT_THROW(prabhakar(2.0, 1.0, 1.5, -1e19), std::runtime_error);  // too far from the axis
  EXPECT_THROW(prabhakar(0.05, 1.0, 1.5, 1e300), std::runtime_error);
}

}  // namespace
}  // namespace fde::reference
