// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace fde::bench {

// Arguments of E_{alpha,beta}(z) as exact decimal texts.
struct MittagLefflerPoint {
  std::string alpha, beta, re, im;
  friend bool operator==(const MittagLefflerPoint&, const MittagLefflerPoint&) = default;
};

// The arguments of the table: first those for which published codes lose digits or fail, then a grid over
// alpha, beta and z. Each once; none whose value overflows double.
std::vector<MittagLefflerPoint> mittag_leffler_points();

}  // namespace fde::bench
