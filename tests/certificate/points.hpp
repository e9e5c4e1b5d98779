// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <string_view>
#include <vector>

namespace fde::reference::certificate {

// Arguments of E_{alpha,beta}(z); the doubles are taken exactly.
struct Point {
  std::string_view region;
  double alpha, beta;
  std::complex<double> z;
};

// The names of the regions, in the order of the points.
std::vector<std::string_view> region_names();

constexpr int points_in_a_region = 500, point_count = 20 * points_in_a_region;

// The point with index 0 <= index < point_count, ordered by region; deterministic. |E| does not overflow a
// double.
Point point(int index);

}  // namespace fde::reference::certificate
