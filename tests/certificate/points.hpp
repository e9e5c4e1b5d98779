#pragma once

#include <complex>
#include <string_view>
#include <vector>

namespace fde::certificate {

// Arguments of E_{alpha,beta}(z); every number is the double it is.
struct Point {
  std::string_view region;
  double alpha, beta;
  std::complex<double> z;
};

// The names of the regions, in the order of the points.
std::vector<std::string_view> region_names();

constexpr int points_in_a_region = 500, point_count = 20 * points_in_a_region;

// Point 0 to point_count - 1, region after region; the same ones each time. |E| does not overflow a double.
Point point(int index);

}  // namespace fde::certificate
