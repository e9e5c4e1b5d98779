// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "certificate/point_check.hpp"

namespace fde::reference::certificate {
namespace {

using Value = std::complex<double>;

// Points where published codes lose digits or return NaN, or where they switch between methods.
struct Hard {
  const char* name;
  std::vector<Point> points;
};

std::vector<Point> fractional_exponentials() {  // E_{1/8}(-x^(1/8))
  std::vector<Point> points;
  for (int k = 0; k <= 200; ++k) points.push_back({"", 0.125, 1.0, -std::pow(0.01 * k, 0.125)});
  return points;
}

std::vector<Point>
scaled_error_functions() {  // E_{1/2}(-x) = e^(x^2) erfc x; NaN from x = 27 on in some codes
  std::vector<Point> points;
  for (double x = 20.0; x <= 40.0; x += 0.5) points.push_back({"", 0.5, 1.0, -x});
  return points;
}

std::vector<Point> on_ray(double alpha, double beta, double turns) {  // arg z = turns * pi
  std::vector<Point> points;
  for (const double size : {0.5, 1.0, 3.0, 10.0, 50.0, 1e3})
    points.push_back({"", alpha, beta, std::polar(size, turns * std::numbers::pi)});
  return points;
}

std::vector<Point> next_to(double alpha) {
  std::vector<Point> points;
  for (const double distance : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
    for (const double z : {-0.5, -5.0, -30.0, -1e3}) {
      points.push_back({"", alpha - distance, 1.0, z});
      points.push_back({"", alpha + distance, alpha, z});
    }
  }
  return points;
}

// E_{3/2}(z) has its largest zeros near -2.117 and -13.8; the points come as close as 1e-9 of |z|.
std::vector<Point> near_zeros() {
  std::vector<Point> points;
  for (const double zero : {-2.1171, -13.766}) {
    for (const double distance : {0.0, 1e-9, -1e-6, 1e-3})
      points.push_back({"", 1.5, 1.0, zero * (1.0 + distance)});
  }
  return points;
}

class HardPoints : public testing::TestWithParam<Hard> {};

// In double the error is at most 8 ulp and within the stated bound; for 50 digits within its bound
// (point_check.hpp).
TEST_P(HardPoints, AreRight) {
  for (const Point& point : GetParam().points) {
    if (point.z == 0.0) continue;  // the value is 1/Gamma(beta); Arb's integral does not apply
    const PointCheck row = check_point(point, 50);
    EXPECT_THAT(row.failures, testing::IsEmpty())
        << fmt::format("E_{{{},{}}}({}{:+}i)", point.alpha, point.beta, point.z.real(), point.z.imag());
  }
}

INSTANTIATE_TEST_SUITE_P(
    MittagLeffler, HardPoints,
    testing::Values(
        Hard{"FractionalExponential", fractional_exponentials()},
        Hard{"ScaledErrorFunction", scaled_error_functions()},
        Hard{"SmallOrderLargeArgument",
             {{"", 0.05, 1.0, -1e4}, {"", 0.01, 1.0, -1e4}, {"", 0.01, 0.01, -1e6}, {"", 0.01, 1.0, -0.99}}},
        Hard{"OrderNextToTwo", {{"", 1.999, 1.0, -1e4}, {"", 1.9999, 1.0, -1e4}, {"", 2.0, 1.0, -1e4}}},
        Hard{"KernelOnItsStokesLine", on_ray(0.3, 0.3, 0.3)}, Hard{"StokesLine", on_ray(0.7, 1.0, 0.7)},
        Hard{"AntiStokesLine", on_ray(0.7, 1.0, 0.35)}, Hard{"NextToOrderOne", next_to(1.0)},
        Hard{"NextToOrderTwo", next_to(2.0)}, Hard{"NearZeros", near_zeros()},
        Hard{"PolesOfGamma",
             {{"", 0.5, 0.0, -3.0},
              {"", 0.5, -1.0, -3.0},
              {"", 0.7, -4.0, Value(2.0, 2.0)},
              {"", 1.0, -2.0, -3.0}}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace fde::reference::certificate
