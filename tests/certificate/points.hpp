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

// 10,000 points, 500 in each region, the same ones each time. |E| does not overflow a double.
std::vector<Point> points();

}  // namespace fde::certificate
