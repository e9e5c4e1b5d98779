// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/shifted_contours.hpp"

#include <algorithm>
#include <cmath>

namespace fde::reference {
namespace {

constexpr int digits = 45;

ContourNodes nodes_of(const ShiftedShape& shape) {
  const Precision precision(digits);
  return ContourNodes(Contour<BigReal>(shape.mu, shape.omega, shape.depth, false), shape.offset);
}

}  // namespace

ShiftedContour::ShiftedContour(const ShiftedShape& of) : shape(of), strip(of), nodes(nodes_of(of)) {}

// The first ones suffice unless singularities have a large imaginary part. Those with mu = 16, 30, 60, 100
// enclose singularities of increasing imaginary part, the one with mu = 64 some on the positive axis; the one
// with mu = 2 leaves singularities far to the left outside.
const std::array<ShiftedContour, 8>& shifted_contours() {
  static const std::array<ShiftedContour, 8> all{
      ShiftedContour({0.0, 6.0, 52.0, 43.5}),     ShiftedContour({0.0, 7.0, 64.0, 60.0}),
      ShiftedContour({0.0, 2.0, 64.0, 60.0}),     ShiftedContour({0.0, 16.0, 128.0, 70.0}),
      ShiftedContour({-14.0, 30.0, 372.0, 46.0}), ShiftedContour({-44.0, 60.0, 800.0, 20.0}),
      ShiftedContour({0.0, 64.0, 420.0, 110.0}),  ShiftedContour({-84.0, 100.0, 1400.0, 12.0})};
  return all;
}

SingularityRoots::SingularityRoots(double alpha, const std::complex<double>& log_z, int first_sheet)
    : log_size(log_z.real()), poles(poles_of(alpha, log_z, first_sheet)) {
  for (const auto& pole : poles.on_near_sheets)
    roots.push_back(std::polar(std::exp(0.5 * pole.log.real()), 0.5 * pole.log.imag()));
}

double SingularityRoots::growth() const {
  double largest = 0.0;
  for (const auto& root : roots) {
    if (root.real() > 0.0) largest = std::max(largest, (root * root).real());
  }
  return largest;
}

}  // namespace fde::reference
