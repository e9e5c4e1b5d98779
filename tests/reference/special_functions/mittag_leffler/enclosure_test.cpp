// SPDX-License-Identifier: MIT
#include "certificate/enclosure.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace fde::reference::certificate {
namespace {

using Value = std::complex<double>;
constexpr int digits = 55;
constexpr long bits = 400;

std::string name_of(double alpha, double beta, Value z) {
  return fmt::format("E_{{{},{}}}({}{:+}i)", alpha, beta, z.real(), z.imag());
}

struct Elementary {
  const char* name;
  double alpha, beta;
  Ball (*value)(const Ball& root);  // as a function of a root s, z = s^alpha
  Ball (*argument)(const Ball& root);
};

class EnclosureOf : public testing::TestWithParam<Elementary> {};

// All three methods against Arb's own functions.
TEST_P(EnclosureOf, MeetsTheElementaryFunction) {
  const auto& [name, alpha, beta, value, argument] = GetParam();
  const WorkingBits scope(bits);
  for (const Value root :
       {Value(0.5), Value(3.0), Value(20.0), Value(-2.5), Value(1.5, -4.0), Value(0.25, 12.0)}) {
    const Ball z = argument(Ball(root)), exact = value(Ball(root));
    for (const Method method : {Method::automatic, Method::power_series, Method::hankel}) {
      const Ball found = enclose({Ball(alpha), Ball(beta), z}, digits, method);
      EXPECT_TRUE(found.overlaps(exact)) << name_of(alpha, beta, z.mid());
      EXPECT_GE(found.accuracy(), 182) << name_of(alpha, beta, z.mid());
    }
  }
}

Ball same(const Ball& s) { return s; }
Ball negative(const Ball& s) { return -s; }
Ball minus_square(const Ball& s) { return -(s * s); }
Ball fourth_power(const Ball& s) { return s * s * s * s; }

INSTANTIATE_TEST_SUITE_P(
    Certificate, EnclosureOf,
    testing::ValuesIn<Elementary>(
        {{"Exponential", 1, 1, [](const Ball& s) { return exp(s); }, same},
         {"ExponentialIntegral", 1, 2, [](const Ball& s) { return (exp(s) - Ball(1.0)) / s; }, same},
         {"ExponentialTwiceDerived", 1, -1, [](const Ball& s) { return s * s * exp(s); }, same},
         {"Cosine", 2, 1, [](const Ball& s) { return cos(s); }, minus_square},
         {"Sine", 2, 2, [](const Ball& s) { return sin(s) / s; }, minus_square},
         {"FourthOrder", 4, 1,
          [](const Ball& s) { return (exp(s) + exp(-s) + Ball(2.0) * cos(s)) / Ball(4.0); }, fourth_power},
         {"ErrorFunction", 0.5, 1, [](const Ball& s) { return exp(s * s) * erfc(s); }, negative}}),
    [](const auto& test) { return std::string(test.param.name); });

struct Sample {
  double alpha, beta;
  Value z;
};

// The two formulas share only the arithmetic, so that an overlap of small balls is evidence for both.
TEST(Enclosure, OfTheSeriesAndOfTheIntegralOverlap) {
  for (const auto& [alpha, beta, z] :
       {Sample{0.3, 0.3, {1.5, -0.5}}, Sample{0.01, 1.0, -0.875}, Sample{0.7, -10.0, -3.0},
        Sample{0.9, 20.0, -30.0}, Sample{1.0 - 0x1p-40, 1.0, -60.0}, Sample{1.999, 1.0, -1e4},
        Sample{1.5, 1.5, {-40.0, 60.0}}, Sample{0.8, -2.0, 7.5}, Sample{2.5, -5.0, -1e4},
        Sample{3.5, 0.0, {1e5, 1e5}}, Sample{5.0, 0.25, -1e9}}) {
    const Ball series = enclose(alpha, beta, z, digits, Method::power_series);
    const Ball integral = enclose(alpha, beta, z, digits, Method::hankel);
    EXPECT_TRUE(series.overlaps(integral)) << name_of(alpha, beta, z);
    EXPECT_GE(series.accuracy(), 182) << name_of(alpha, beta, z);
    EXPECT_GE(integral.accuracy(), 182) << name_of(alpha, beta, z);
  }
}

// E_{alpha,beta}(z) = 1/Gamma(beta) + z E_{alpha,alpha+beta}(z), for arguments too large for the power
// series.
TEST(Enclosure, SatisfiesTheRecurrenceFarOut) {
  const WorkingBits scope(bits);
  for (const auto& [alpha, beta, z] :
       {Sample{0.01, 1.0, -1e10}, Sample{0.02, 0.5, {3.0, 4.0}}, Sample{0.5, 0.5, {0.0, 1e6}},
        Sample{1.0 + 0x1p-40, 1.0, -1e10}, Sample{1.999, 1.999, -1e10}, Sample{0.25, -1.0, {-1e7, 1e-3}}}) {
    const Ball next = enclose({Ball(alpha), Ball(alpha) + Ball(beta), Ball(z)}, digits);
    const Ball sum = reciprocal_gamma(Ball(beta)) + Ball(z) * next;
    EXPECT_TRUE(sum.overlaps(enclose(alpha, beta, z, digits))) << name_of(alpha, beta, z);
  }
}

TEST(Enclosure, KeepsItsRelativeAccuracyNextToAZero) {
  const Ball value = enclose(2.0, 1.0, -2.4674011002723395, digits);  // cos of about pi/2
  EXPECT_LT(std::abs(value.mid()), 1e-15);
  EXPECT_GE(value.accuracy(), 182);
}

TEST(Enclosure, IsExactAtTheOrigin) {
  EXPECT_EQ(enclose(0.7, -3.0, 0.0, digits).mid(), 0.0);
  EXPECT_EQ(enclose(0.7, 4.0, 0.0, digits).mid(), 1.0 / 6.0);
}

}  // namespace
}  // namespace fde::reference::certificate
