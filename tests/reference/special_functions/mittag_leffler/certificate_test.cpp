// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "certificate/enclosure.hpp"
#include "certificate/point_check.hpp"
#include "certificate/points.hpp"

namespace fde::reference::certificate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Value = std::complex<double>;

TEST(Points, AreTheSameEachTime) {
  EXPECT_EQ(point(7).z, point(7).z);
  EXPECT_NE(point(7).z, point(8).z);
}

TEST(Points, FillTheRegionsOneAfterTheOther) {
  EXPECT_EQ(static_cast<int>(region_names().size()) * points_in_a_region, point_count);
  EXPECT_EQ(point(0).region, region_names().front());
  EXPECT_EQ(point(point_count - 1).region, region_names().back());
}

// One point of each region; the command fde_certificate checks all of them.
TEST(Judge, FindsNoFault) {
  for (int i = 3; i < point_count; i += points_in_a_region) {
    const PointCheck row = check_point(point(i), 50);
    EXPECT_THAT(row.failures, IsEmpty()) << row.point.region;
  }
}

// Results with an error of `ulps` ulp and a stated bound of `stated_ulps` ulp.
Implementations with_error(double ulps, double stated_ulps) {
  Implementations faces = library_implementations();
  faces.evaluate_in_double = [=](const Point& x) {
    const double value = enclose(x.alpha, x.beta, x.z, 30).mid().real();
    const double ulp = std::ldexp(1.0, std::ilogb(value) - 52);
    return MittagLefflerValue{value + ulps * ulp, stated_ulps * ulp};
  };
  return faces;
}

constexpr Point steep{"", 1.0, 1.0, 600.0};  // e^600: |z E'| = 600 |E|, and no zero

TEST(Judge, SeesAnErrorAboveTheStatedBound) {
  EXPECT_THAT(check_point(steep, 0, with_error(3, 4)).failures, IsEmpty());
  EXPECT_THAT(check_point(steep, 0, with_error(3, 2)).failures, ElementsAre("error above the stated bound"));
  EXPECT_THAT(check_point(steep, 0, with_error(NAN, 4)).failures, ElementsAre(HasSubstr("not finite")));
  EXPECT_THAT(check_point(steep, 0, with_error(0, NAN)).failures,
              ElementsAre("error above the stated bound"));
}

TEST(Judge, SeesEightUlp) {
  EXPECT_NEAR(check_point(steep, 0, with_error(7, 20)).ulps, 7.0, 0.5);
  EXPECT_THAT(check_point(steep, 0, with_error(7, 20)).failures, IsEmpty());
  EXPECT_THAT(check_point(steep, 0, with_error(9, 20)).failures, ElementsAre("error above 8 ulp"));
}

// E_2(z) = cos sqrt(-z) has a zero at -(pi/2)^2, where |z E'| = pi/4.
TEST(Judge, MeasuresAgainstTheSlopeNextToAZero) {
  const double zero = -0.25 * M_PI * M_PI;
  const Point close{"", 2.0, 1.0, zero * (1.0 + 1e-9)}, far{"", 2.0, 1.0, 0.25 * zero};
  const PointCheck row = check_point(close, 0, with_error(1e6, 2e6));
  EXPECT_THAT(row.failures, IsEmpty());
  EXPECT_NEAR(row.ulps, 1e6, 1.0);
  EXPECT_LT(row.conditioned_ulps, 0.01);
  EXPECT_THAT(check_point(close, 0, with_error(1e11, 2e11)).failures, ElementsAre("error above 8 ulp"));
  EXPECT_THAT(check_point(far, 0, with_error(9, 20)).failures, ElementsAre("error above 8 ulp"));
}

// E_{2,3}(-x) = (1 - cos sqrt x)/x has a double zero at (2 pi)^2.
TEST(Judge, MeasuresAgainstTheSlopeNextToADoubleZero) {
  const Point close{"", 2.0, 3.0, -4.0 * M_PI * M_PI * (1.0 + 1e-4)};
  EXPECT_THAT(check_point(close, 0, with_error(1e3, 2e3)).failures, IsEmpty());
  EXPECT_THAT(check_point(close, 0, with_error(1e7, 2e7)).failures, ElementsAre("error above 8 ulp"));
}

TEST(Judge, AllowsInfinityOnlyWhereTheValueOverflows) {
  Implementations infinite = library_implementations();
  infinite.evaluate_in_double = [](const Point&) { return MittagLefflerValue{INFINITY, INFINITY}; };
  EXPECT_THAT(check_point({"", 1.0, 1.0, 710.0}, 0, infinite).failures, IsEmpty());
  EXPECT_THAT(check_point({"", 1.0, 1.0, 709.5}, 0, infinite).failures, ElementsAre(HasSubstr("not finite")));
  EXPECT_THAT(check_point({"", 1.0, 0.0, -710.0}, 0, infinite).failures,
              ElementsAre(HasSubstr("not finite")));
}

TEST(Judge, SeesDigitsThatAreWrongOrFew) {
  Implementations faces = library_implementations();
  faces.in_digits = [](const Point&, int) { return DecimalComplex{"2.71828182845904523536", "0", "1e-20"}; };
  const Point one{"", 1.0, 1.0, 1.0};
  EXPECT_THAT(check_point(one, 20, faces).failures, IsEmpty());
  EXPECT_THAT(check_point(one, 30, faces).failures, ElementsAre(HasSubstr("not as small as promised")));
  faces.in_digits = [](const Point&, int) { return DecimalComplex{"2.71828182845904523537", "0", "1e-21"}; };
  EXPECT_THAT(check_point(one, 20, faces).failures, ElementsAre(HasSubstr("above the stated bound")));
}

TEST(ExactText, NamesTheDoubleAndNotTheDecimal) {
  EXPECT_EQ(exact_text(0.1), "0.1000000000000000055511151231257827021181583404541015625");
  EXPECT_EQ(exact_text(-3.0), "-3");
}

}  // namespace
}  // namespace fde::reference::certificate
