// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/quick_contours.hpp"

#include <algorithm>

namespace fde::reference {
namespace {

constexpr int digits = 45;

DoubleDouble half_log(double x) {
  const Precision precision(digits);
  return to_double_double(log(BigReal(x)) / 2);
}

ContourNodes nodes_of(const ContourShape& shape) {
  const Precision precision(digits);
  return ContourNodes(Contour<BigReal>(shape.mu, shape.omega, shape.depth, shape.half_step_shift));
}

}  // namespace

QuickContour::QuickContour(const ContourShape& of)
    : shape(of), bound(of), half_log_mu(half_log(of.mu)), nodes(nodes_of(of)) {}

const QuickContour& QuickContours::away_from(std::span<const std::complex<double>> roots) const {
  const auto clearance = [&](const QuickContour& contour) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& root : roots) least = std::min(least, contour.shape.steps_to_node(root));
    return least;
  };
  const auto& [plain, shifted] = staggered;
  return clearance(plain) >= clearance(shifted) ? plain : shifted;
}

// mu near -exponent keeps the terms as small as 1/Gamma(-exponent); with a large depth the sum extends until
// s^exponent e^s has decayed. The last contour has terms of the size of the value, and three times as many:
// its rounding error is the smallest.
const std::array<QuickContours, 6>& quick_contours() {
  const auto both = [](double mu, double omega, double depth) {
    return std::array{QuickContour({mu, omega, depth, false}), QuickContour({mu, omega, depth, true})};
  };
  static const std::array<QuickContours, 6> all{{{-2.5, 2.5, both(6.0, 52.0, 43.5)},
                                                 {-3.0, 3.0, both(7.0, 64.0, 60.0)},
                                                 {-3.0, 25.0, both(7.0, 64.0, 140.0)},
                                                 {-25.0, 10.0, both(16.0, 128.0, 70.0)},
                                                 {-60.0, 20.0, both(32.0, 256.0, 90.0)},
                                                 {-4.0, 25.0, both(2.0, 96.0, 140.0)}}};
  return all;
}

}  // namespace fde::reference
