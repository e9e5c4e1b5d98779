// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <tuple>

#include "fdebench/schemes/problem/progress/progress.hpp"
#include "support/worst_row.hpp"

namespace fde::reference {
namespace {

using Value = std::complex<double>;
using Wide = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60>,
                                           boost::multiprecision::et_off>;

std::string name_of(double alpha, double beta, Value z) {
  return fmt::format("E_{{{},{}}}({}{:+}i)", alpha, beta, z.real(), z.imag());
}

struct KnownCase {
  double alpha, beta;
  Value z, value;
};

// mpmath 1.3: the power series summed at 60 to 300 digits, and for E_0.05 and the last two, where it cannot
// be summed, 400 terms of the asymptotic series at 60 digits. The doubles are taken exactly, not as decimals.
const std::vector<KnownCase> known_values{
    {0.5, 1.0, -1.0, 0.42758357615580700441},
    {0.125, 1.0, -1.2, 0.43641412131788405507},
    {0.05, 1.0, -1e4, 9.6941225691853229059e-05},
    {1.999, 1.0, -1e4, 0.88332475971357804301},
    {0.999, 0.999, -50.0, 4.3499031575799847253e-07},
    {1.25, 0.5, -30.0, -0.0068234753742185010871},
    {0.7, -0.3, -3.0, -0.061558349440021325615},
    {2.5, 3.0, -200.0, 0.099350147050283236063},
    {4.3, 1.5, 1e3, 15.063353190411663652},
    {0.9, 2.0, {3.0, 4.0}, {-2.4524271111603654369, -3.1131484855851943653}},
    {0.3, 0.3, {0.5877852522924731, 0.8090169943749475}, {-0.38897322733675684169, 0.40768686471197917200}},
    {0.3,
     0.3,
     {5.877852522924732, 8.090169943749475},
     {-9.7946568451283241832e-4, -2.2783639201183284323e-3}},
    {0.3,
     0.3,
     {29.389262614623657, 40.45084971874737},
     {-3.0637691995107871174e-5, -8.8581831400901325579e-5}},
};

TEST(MittagLeffler, MeetsValuesFromAnIndependentSummation) {
  bench::WorstRow worst;
  for (const auto& [alpha, beta, z, value] : known_values) {
    worst.update(std::abs(mittag_leffler(alpha, beta, z).value - value), 4e-16 * std::abs(value),
                 name_of(alpha, beta, z));
  }
  expect_within(worst);
}

TEST(MittagLeffler, BoundsItsError) {
  bench::WorstRow worst;
  for (const auto& [alpha, beta, z, value] : known_values) {
    const auto [computed, bound] = mittag_leffler(alpha, beta, z);
    EXPECT_LE(bound, 1e-15 * std::abs(value)) << name_of(alpha, beta, z);
    // The values of the table are themselves rounded to double.
    worst.update(std::abs(computed - value), bound + 2e-16 * std::abs(value), name_of(alpha, beta, z));
  }
  expect_within(worst);
}

struct Elementary {
  const char* name;
  double alpha, beta;
  double (*argument)(double x);
  Wide (*value)(const Wide& x);
};

class MittagLefflerElementary : public testing::TestWithParam<Elementary> {};

TEST_P(MittagLefflerElementary, IsExactToTheLastDigits) {
  const auto& [name, alpha, beta, argument, value] = GetParam();
  bench::WorstRow worst;
  for (const double x : {0.0078125, 0.25, 1.0, 1.5, 3.0, 7.25, 20.0, 25.5}) {
    const double z = argument(x);  // exact: x has few bits
    const auto exact = value(Wide(x)).convert_to<double>();
    worst.update(std::abs(mittag_leffler(alpha, beta, z) - exact), 4e-16 * std::abs(exact),
                 name_of(alpha, beta, z));
  }
  expect_within(worst);
}

Wide erfcx(const Wide& x) { return exp(x * x) * erfc(x); }

INSTANTIATE_TEST_SUITE_P(
    MittagLeffler, MittagLefflerElementary,
    testing::ValuesIn<Elementary>(
        {{"ExponentialGrowth", 1, 1, [](double x) { return x; }, [](const Wide& x) { return Wide(exp(x)); }},
         {"ExponentialDecay", 1, 1, [](double x) { return -x; }, [](const Wide& x) { return Wide(exp(-x)); }},
         {"ExponentialIntegral", 1, 2, [](double x) { return -x; },
          [](const Wide& x) { return Wide(-expm1(-x) / x); }},
         {"ExponentialDerivative", 1, 0, [](double x) { return -x; },
          [](const Wide& x) { return Wide(-x * exp(-x)); }},
         {"Cosine", 2, 1, [](double x) { return -x * x; }, [](const Wide& x) { return Wide(cos(x)); }},
         {"Sine", 2, 2, [](double x) { return -x * x; }, [](const Wide& x) { return Wide(sin(x) / x); }},
         {"HyperbolicCosine", 2, 1, [](double x) { return x * x; },
          [](const Wide& x) { return Wide(cosh(x)); }},
         {"ScaledErrorFunction", 0.5, 1, [](double x) { return -x; }, erfcx},
         {"ScaledErrorFunctionGrowing", 0.5, 1, [](double x) { return x; },
          [](const Wide& x) { return erfcx(Wide(-x)); }}}),
    [](const auto& test) { return test.param.name; });

struct Sample {
  double alpha, beta;
  Value z;
};

// Real negative arguments up to 1e4 in modulus and complex ones, with the betas that occur in equations.
std::vector<Sample> samples(int count) {
  std::mt19937_64 random(
      20240517);  // NOLINT(bugprone-random-generator-seed,cert-msc51-cpp): the same rows each time
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Sample> rows;
  for (int i = 0; i < count; ++i) {
    const double alpha = 0.05 + 1.95 * unit(random);
    const std::array<double, 6> betas{1.0, alpha, 2.0, 0.5, alpha + 1.0, 3.0 * unit(random)};
    const double beta = betas[static_cast<std::size_t>(i) % betas.size()];
    const double exponent = unit(random), angle = std::numbers::pi * unit(random);
    if (i % 2 == 0) {
      rows.push_back({alpha, beta, -std::pow(10.0, 7.0 * exponent - 3.0)});
    } else {  // moderate, or the exponential dominates
      rows.push_back(
          {alpha, beta, std::polar(std::pow(10.0, 3.0 * exponent - 2.0) * std::min(1.0, alpha), angle)});
    }
  }
  return rows;
}

// All digits of a double, so that the overload for decimal texts has the same argument.
std::string exactly(double x) { return Wide(x).str(0, std::ios_base::scientific); }

TEST(MittagLeffler, FacesAgree) {
  bench::WorstRow worst;
  for (const auto& [alpha, beta, z] : samples(300)) {
    const auto [value, bound] = mittag_leffler(alpha, beta, z);
    if (!std::isfinite(bound)) continue;
    const auto digits =
        mittag_leffler(exactly(alpha), exactly(beta), exactly(z.real()), exactly(z.imag()), 25);
    const Wide off_re = Wide(digits.re) - value.real(), off_im = Wide(digits.im) - value.imag();
    const auto error = hypot(off_re, off_im).convert_to<double>();
    worst.update(error, std::min(bound * 1.001, 1e-15 * std::abs(value)), name_of(alpha, beta, z));
  }
  expect_within(worst);
}

TEST(MittagLeffler, IsConjugateSymmetric) {
  for (const auto& [alpha, beta, z] : samples(60)) {
    EXPECT_EQ(mittag_leffler(alpha, beta, std::conj(z)).value,
              std::conj(mittag_leffler(alpha, beta, z).value))
        << name_of(alpha, beta, z);
  }
}

// E_{alpha,beta}(z) = 1/Gamma(beta) + z E_{alpha,alpha+beta}(z)
TEST(MittagLeffler, SatisfiesTheRecurrence) {
  bench::WorstRow worst;
  for (const auto& [alpha, beta, z] : samples(200)) {
    const Value left = mittag_leffler(alpha, beta, z).value,
                next = z * mittag_leffler(alpha, alpha + beta, z).value;
    const double head = 1.0 / std::tgamma(beta);
    const double size = std::abs(left) + std::abs(next) + std::abs(head);  // alpha + beta is rounded as well
    worst.update(std::abs(head + next - left), 2e-14 * size, name_of(alpha, beta, z));
  }
  expect_within(worst);
}

// E_{2 alpha,beta}(z^2) = (E_{alpha,beta}(z) + E_{alpha,beta}(-z)) / 2
TEST(MittagLeffler, SatisfiesTheDuplicationFormula) {
  bench::WorstRow worst;
  for (const double alpha : {0.25, 0.5, 0.75, 1.0, 1.5, 2.5}) {
    for (const Value z : {Value(-1.5), Value(0.0, 2.0), Value(0.5, -1.5)}) {
      const Value plus = mittag_leffler(alpha, 0.75, z).value, minus = mittag_leffler(alpha, 0.75, -z).value;
      const double size = std::abs(plus) + std::abs(minus);
      worst.update(std::abs(mittag_leffler(2.0 * alpha, 0.75, z * z).value - 0.5 * (plus + minus)),
                   1e-15 * size, name_of(alpha, 0.75, z));
    }
  }
  expect_within(worst);
}

// alpha z E'_{alpha,beta}(z) = E_{alpha,beta-1}(z) - (beta-1) E_{alpha,beta}(z), with E' by a central
// difference of rate 4.
TEST(MittagLeffler, HasTheRightDerivative) {
  bench::WorstRow worst;
  constexpr double alpha = 0.75, beta = 1.25, h = 0x1p-9;
  for (const double z : {-8.0, -1.0, 0.5, 2.0}) {
    const auto at = [&](double x) { return mittag_leffler(alpha, beta, x); };
    const double slope = (8.0 * (at(z + h) - at(z - h)) - (at(z + 2.0 * h) - at(z - 2.0 * h))) / (12.0 * h);
    const double right = mittag_leffler(alpha, beta - 1.0, z) - (beta - 1.0) * at(z);
    worst.update(std::abs(alpha * z * slope - right), 1e-9 * std::abs(right), name_of(alpha, beta, z));
  }
  expect_within(worst);
}

TEST(MittagLeffler, IsTheReciprocalGammaFunctionAtZero) {
  EXPECT_DOUBLE_EQ(mittag_leffler(0.7, 2.5, 0.0), 1.0 / std::tgamma(2.5));
  EXPECT_EQ(mittag_leffler(0.7, 0.0, 0.0), 0.0);
  EXPECT_EQ(mittag_leffler(0.7, -3.0, 0.0), 0.0);
  EXPECT_EQ(mittag_leffler("0.7", "-3", "0", "0", 20).re, "0");
}

TEST(MittagLeffler, OverflowsOnlyWhereTheValueDoes) {
  EXPECT_DOUBLE_EQ(mittag_leffler(1.0, 1.0, 709.5), std::exp(709.5));
  EXPECT_EQ(mittag_leffler(1.0, 1.0, 710.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(mittag_leffler(0.05, 1.0, 2.0), std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(mittag_leffler(1.0, 1.0, -700.0), std::exp(-700.0));
}

// s* = z^(1/alpha) has 1e300 digits before the point: e^s* overflows for a positive s*, and its phase cannot
// be computed for any other.
TEST(MittagLeffler, OverflowsAtOnceForTheSmallestOrders) {
  EXPECT_EQ(mittag_leffler(1e-300, 1.0, 8.3), std::numeric_limits<double>::infinity());
  EXPECT_EQ(mittag_leffler(1.1e-311, -3.0, 8.3e299), std::numeric_limits<double>::infinity());
  EXPECT_THROW(mittag_leffler(1.1e-311, -3.0, Value(8.3e299, 1e-300)), std::runtime_error);
  EXPECT_THROW(mittag_leffler(1e-20, 0.5, Value(8.3, 1e-20)), std::runtime_error);
}

// e^s* with an s* of 1633 digits before the point: only the signs of its parts are representable. mpmath,
// 3600 digits.
TEST(MittagLeffler, OverflowsWithoutAContourWhereThePhaseIsKnown) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  mittag_leffler(0.5, 1.0, -1.0);  // computes the tables
  std::size_t work = 0;
  const ProgressScope scope([&](std::size_t, std::size_t) { ++work; });
  EXPECT_EQ(mittag_leffler(0.05625, 1.0, {6.5e91, 1e-231}).value, Value(infinity, infinity));
  EXPECT_EQ(mittag_leffler(0.05625, 1.0, {6.5e91, 1e80}).value, Value(-infinity, -infinity));
  EXPECT_EQ(work, 0U);
}

// Decimal arguments are taken exactly. mpmath as above.
TEST(MittagLefflerDigits, MeetsThirtyDigits) {
  const auto value = [](const char* alpha, const char* beta, const char* z) {
    return mittag_leffler(alpha, beta, z, "0", 30).re;
  };
  EXPECT_EQ(value("0.125", "1", "-1.2"), "0.436414121317884045911315151886");
  EXPECT_EQ(value("0.05", "1", "-1e4"), "0.0000969412256918532292376539285723");
  EXPECT_EQ(value("1.999", "1", "-10000"), "0.883324759713577367177917259065");
  EXPECT_EQ(value("0.999", "0.999", "-50"), "4.34990315757998086400059224042e-07");
  EXPECT_EQ(value("4.3", "1.5", "1000"), "15.0633531904116583422161080902");
}

TEST(MittagLefflerDigits, BoundIncludesTheRoundingOfTheText) {
  for (const int digits : {1, 5, 50, 300}) {
    const auto [re, im, bound] = mittag_leffler("0.5", "1", "-2.5", "0", digits);
    using Wider = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<320>,
                                                boost::multiprecision::et_off>;
    const Wider x("2.5"), exact = exp(x * x) * erfc(x), error = abs(Wider(re) - exact);
    EXPECT_LE(error, Wider(bound)) << digits;
    EXPECT_LE(Wider(bound), exact * pow(Wider(10), 1 - digits)) << digits;
    EXPECT_EQ(im, "0");
  }
}

// 1/Gamma next to a pole, and a first asymptotic term that vanishes there, for arguments with more digits
// than requested. mpmath 1.3: rgamma and three terms of the asymptotic series at 80 digits.
TEST(MittagLefflerDigits, ArgumentsHaveAllTheirDigits) {
  EXPECT_EQ(mittag_leffler("0.5", "-1.9999999999999999999999999999999999999999", "0", "0", 20).re,
            "2.0000000000000000000e-40");
  EXPECT_EQ(mittag_leffler("0.5", "-2", "0", "0", 20).re, "0");
  EXPECT_EQ(mittag_leffler("0.5", "0.5", "-1e4000", "0", 20).re, "2.8209479177387814347e-8001");
  EXPECT_EQ(mittag_leffler("0.3", "-0.7", "-1e50", "0", 20).re, "-3.0044944170796073955e-101");
}

// Large |beta|: E_{a,b}(z) = 1/Gamma(b) + z E_{a,a+b}(z) at 30 digits.
TEST(MittagLefflerDigits, TakesLargeBeta) {
  using Decimals = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60>,
                                                 boost::multiprecision::et_off>;
  for (const char* beta : {"600.25", "-500.25", "-2000.25", "9000.75"}) {
    const Decimals next = Decimals(beta) + Decimals("0.5");
    const Decimals left(mittag_leffler("0.5", beta, "-2", "0", 30).re);
    const Decimals right(mittag_leffler("0.5", next.str(10), "-2", "0", 30).re);
    const Decimals head = 1 / tgamma(Decimals(beta));
    EXPECT_LE(abs(Decimals((head - 2 * right - left) / left)), Decimals("1e-27")) << beta;
  }
}

// The order is far below the last digit of beta in double: E_{a,b}(z) = 1/((1-z) Gamma(b)) + O(a), and for
// b = -1 the first term is 0.
TEST(MittagLeffler, TakesTheSmallestOrders) {
  EXPECT_NEAR(mittag_leffler(1e-60, 1.0, -0.5), 1.0 / 1.5, 1e-16);
  EXPECT_NEAR(mittag_leffler(5e-324, 0.5, 0.5), 2.0 / std::sqrt(std::numbers::pi), 1e-15);
  EXPECT_NEAR(mittag_leffler(1e-60, -1.0, -0.5) / 1e-60, 0.5 / 2.25, 1e-15);
}

// |E| <= 2 / Gamma(beta), far below the smallest double; for large arguments the same by the integral along
// s = beta (1 + i x)^2, with s* on another sheet, to the left of it, or with a negligible e^s*.
TEST(MittagLeffler, VanishesWithoutWorkForALargeBeta) {
  std::size_t work = 0;
  const ProgressScope scope([&](std::size_t, std::size_t) { ++work; });
  for (const auto& [alpha, beta, z] : {std::tuple{0.5, 500.0, std::complex(-3.0)},
                                       {0.01, 9000.0, {0.3, 400.0}},
                                       {2.0, 200.5, {50.0, -70.0}},
                                       {1.5e-7, 5945.5, {3.0, -8e279}},
                                       {4e-9, 9467.5, {10.0, 1.0}},
                                       {2.0, 300.5, -1e5},
                                       {0.9, 400.0, {1.0, -1e4}}}) {
    const auto [value, bound] = mittag_leffler(alpha, beta, z);
    EXPECT_EQ(value, 0.0) << beta;
    EXPECT_EQ(bound, std::numeric_limits<double>::denorm_min()) << beta;
  }
  EXPECT_EQ(work, 0U);
}

// Next to beta = 0 and z = 0 the value is beta + z / Gamma(alpha + beta), as small as they are;
// 1/Gamma(alpha) is alpha for the smallest alpha.
TEST(MittagLeffler, TakesTheSmallestArguments) {
  const auto [value, bound] = mittag_leffler(0.5, 0x1p-1000, std::complex(0.0, 0x1p-1010));
  EXPECT_EQ(value.real(), 0x1p-1000);
  EXPECT_NEAR(value.imag(), 0x1p-1010 / std::sqrt(std::numbers::pi), bound);
  EXPECT_LE(bound, 8 * 0x1p-1053);
  EXPECT_EQ(mittag_leffler(0x1p-1030, -0x1p-1030, -0x1p-30), -0x1p-1030);
}

TEST(MittagLefflerDigits, PrecisionOfTheCallerIsUntouched) {
  const unsigned before = boost::multiprecision::mpfr_float::default_precision();
  mittag_leffler("0.5", "1", "-2.5", "0", 70);
  EXPECT_EQ(boost::multiprecision::mpfr_float::default_precision(), before);
}

TEST(MittagLeffler, RejectsArgumentsItIsNotDefinedFor) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mittag_leffler(0.0, 1.0, 1.0), std::invalid_argument);
  EXPECT_THROW(mittag_leffler(5.5, 1.0, 1.0), std::invalid_argument);
  EXPECT_THROW(mittag_leffler(nan, 1.0, 1.0), std::invalid_argument);
  EXPECT_THROW(mittag_leffler(0.5, nan, 1.0), std::invalid_argument);
  EXPECT_THROW(mittag_leffler(0.5, -1e40, 1.0), std::invalid_argument);
  EXPECT_THROW(mittag_leffler(0.5, 1.0, Value(0.0, nan)), std::invalid_argument);
  EXPECT_THROW(mittag_leffler("half", "1", "1", "0", 20), std::invalid_argument);
  EXPECT_THROW(mittag_leffler("0.5", "1", "1", "inf", 20), std::invalid_argument);
  EXPECT_THROW(mittag_leffler("0.5", "1", "1", "0", 0), std::invalid_argument);
}

}  // namespace
}  // namespace fde::reference
