// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/laplace/enclosed_transform.hpp"
#include "fdebench/reference/special_functions/laplace/separate_contours.hpp"
#include "support/message_of.hpp"

namespace fde::reference {
namespace {

using ContourPoint = EnclosingContour::Point;

// F(s) = product of (s - s_j)^-order_j, and its inverse Laplace transform at time 1.
struct RationalTransform {
  const char* name;
  std::vector<ContourPoint> singularities;
  std::vector<double> orders;
  BigComplex (*exact)();
  bool real = false;
};

BigComplex big(const ContourPoint& s) { return {BigReal(s.real()), BigReal(s.imag())}; }

BigComplex transform(const RationalTransform& x, const EnclosingContour::Node& node) {
  BigComplex product(1);
  for (std::size_t j = 0; j < x.orders.size(); ++j)
    product *= exp(BigReal(-x.orders[j]) * log(BigComplex(node.s - big(x.singularities[j]))));
  return product;
}

EnclosingContour::Majorant majorant(const RationalTransform& x) {
  return [x](const EnclosingContour::Disc& disc) {
    long double sum = 0.0L;
    for (std::size_t j = 0; j < x.orders.size(); ++j) {
      const long double distance = std::abs(disc.centre - x.singularities[j]) - disc.radius;
      if (distance <= 0.0L) return std::numeric_limits<long double>::infinity();
      sum -= static_cast<long double>(x.orders[j]) * std::log(distance);
    }
    return sum;
  };
}

class EnclosingContourOf : public testing::TestWithParam<RationalTransform> {};

TEST_P(EnclosingContourOf, InvertsWithinItsBound) {
  const RationalTransform& x = GetParam();
  for (const int digits : {5, 16, 50, 150}) {
    const EnclosingContour contour(x.singularities, digits, {.order = 3.0L});
    const Precision precision(contour.working_digits());
    BoundedSum<BigReal> sum;
    for (const auto& node : x.real ? contour.upper_nodes() : contour.nodes())
      sum.add(BigComplex(node.weight * transform(x, node)), BigReal(100 * epsilon<BigReal>()));
    const BigComplex value = x.real ? BigComplex(2 * real_part<BigReal>(sum.value)) : sum.value;
    const BigReal bound = exp(BigReal(contour.log_bound(majorant(x)))),
                  off = norm1(BigComplex(value - x.exact()));
    const BigReal unit = exp(BigReal(contour.sigma()));
    EXPECT_LE(off, 2 * (bound + sum.error)) << digits;
    EXPECT_LE(bound, unit * pow(BigReal(10), 2 - digits)) << digits;
    EXPECT_LE(sum.error, unit * pow(BigReal(10), 2 - digits)) << digits;
  }
}

BigReal pair_on_axis(const BigReal& y) { return (1 - cos(y)) / (y * y); }

INSTANTIATE_TEST_SUITE_P(
    , EnclosingContourOf,
    testing::ValuesIn<RationalTransform>(
        {{"BranchPoint", {0.0L}, {0.5}, [] { return BigComplex(1 / sqrt(pi<BigReal>())); }, true},
         {"TriplePole", {2.0L}, {3.0}, [] { return BigComplex(exp(BigReal(2)) / 2); }, true},
         // J_0(5): two branch points
         {"BesselFunction",
          {ContourPoint(0.0L, 5.0L), ContourPoint(0.0L, -5.0L)},
          {0.5, 0.5},
          [] {
            BigReal value;
            mpfr_j0(value.backend().data(), BigReal(5).backend().data(), MPFR_RNDN);
            return BigComplex(value);
          },
          true},
         {"FarPair",
          {0.0L, ContourPoint(0.0L, 100.0L), ContourPoint(0.0L, -100.0L)},
          {1.0, 1.0, 1.0},
          [] { return BigComplex(pair_on_axis(BigReal(100))); },
          true},
         {"DoublePoleOnOneSide",
          {0.0L, ContourPoint(-3.0L, 60.0L)},
          {1.0, 2.0},
          [] {
            const BigComplex pole(-3, 60);
            return BigComplex(BigReal(1) / (pole * pole) +
                              exp(pole) * (BigReal(1) / pole - BigReal(1) / (pole * pole)));
          }},
         // e^-1000 is negligible at all requested digits
         {"LeavesOutWhatDoesNotMatter",
          {0.0L, -1000.0L},
          {1.0, 1.0},
          [] { return BigComplex(BigReal(-expm1(BigReal(-1000)) / 1000)); },
          true},
         {"LargeGrowth",
          {1e8L, 0.0L},
          {1.0, 2.0},
          [] {
            const BigReal pole(1e8);
            return BigComplex((exp(pole) - 1 - pole) / (pole * pole));
          },
          true}}),
    [](const auto& test) { return test.param.name; });

TEST(EnclosingContour, GrowsWithTheHeightOfItsSingularitiesOnly) {
  const EnclosingContour low({0.0L}, 50),
      high({0.0L, ContourPoint(0.0L, 1e3L), ContourPoint(0.0L, -1e3L)}, 50);
  EXPECT_LE(low.count(), 80);
  EXPECT_LE(high.count(), 5000);
  EXPECT_EQ(EnclosingContour({0.0L, ContourPoint(-1e6L, 1e6L), ContourPoint(-1e6L, -1e6L)}, 50).count(),
            low.count());
}

TEST(EnclosingContour, RefusesWhatIsTooFarApart) {
  bench::expect_message<std::runtime_error>(
      [] {
        EnclosingContour({ContourPoint(0.0L, 1e12L), ContourPoint(0.0L, -1e12L)}, 16);
      },
      "2e+12 apart");
  EXPECT_THROW(EnclosingContour({}, 16), std::invalid_argument);
}

TEST(SeparateContours, CostNoMoreForGroupsFartherApart) {
  const auto nodes = [](long double height) {
    const auto contours =
        separate_contours({0.0L, ContourPoint(-1.0L, height), ContourPoint(-1.0L, height + 2.0L)}, 50, {});
    EXPECT_EQ(contours.size(), 2U);
    EXPECT_LE(contours[0].half_width() + contours[1].half_width(),
              contours[1].height() - contours[0].height());
    return contours[0].count() + contours[1].count();
  };
  EXPECT_EQ(nodes(1e4L), nodes(1e7L));
  EXPECT_EQ(separate_contours({0.0L, ContourPoint(-1.0L, 20.0L)}, 50, {}).size(), 1U);
}

// A singularity far to the left does not count, unless it is near the contour of another one.
TEST(SeparateContours, LeaveOutWhatIsNegligible) {
  EXPECT_EQ(separate_contours({0.0L, ContourPoint(-1e6L, 1e6L)}, 20, {}).size(), 1U);
  // it would be at height 0 without the second one
  EXPECT_EQ(separate_contours({0.0L, ContourPoint(-55.0L, 1.0L)}, 20, {}).front().height(), 0.5L);
}

TEST(SeparateContours, RefuseWhatLongDoubleDoesNotResolve) {
  bench::expect_message<std::runtime_error>([] { separate_contours({ContourPoint(0.0L, 1e12L)}, 16, {}); },
                                            "0 +1e+12 i is too far from the real axis");
}

// A majorant that overflows or is NaN also at the centres of the discs gives no bound.
TEST(EnclosedTransform, SaysWhereThereIsNoBound) {
  for (const long double off : {std::numeric_limits<long double>::max(), std::nanl("")}) {
    EnclosedTransform transform{.singularities = {0.0L}, .real = true};
    transform.prepare = [] {
      return EnclosedTransform::Evaluation{
          .add = [](const EnclosingContour::Node& node, EnclosedTransform::Sums& sums) {
            sums.resize(1);
            sums.front().add(BigComplex(node.weight / node.s), epsilon<BigReal>());
          }};
    };
    transform.majorants = {[=](const EnclosingContour::Disc&) { return off; }};
    const Precision precision(20);
    try {
      invert(transform, 2);
      FAIL();
    } catch (const std::runtime_error& error) {
      const std::string text = error.what();
      EXPECT_TRUE(text.find("no accurate value in reach") != std::string::npos ||
                  text.find("no bound of the transform") != std::string::npos)
          << text;
    }
  }
}

}  // namespace
}  // namespace fde::reference
