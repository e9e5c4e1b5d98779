// SPDX-License-Identifier: MIT
// Boundaries of the regions of linear stability. CSV, one row a point of the boundary:
//
//   scheme, order    z = lambda h^order of D^order y = lambda y
//   line             boundary, or sector for the rays |arg z| = order pi/2 of the exact equation
//   piece            the points of a piece form one curve, in this order
//   theta            the scheme has a mode exp(i n theta) at z (exp(-i n theta) at the conjugate of z)
//   re, im           z. Of the root locus curve (a mode on the unit circle) only those parts are printed that
//                    separate stable from unstable z

#include <fmt/format.h>

#include <complex>
#include <numbers>

#include "fdebench/benchmarks/programs/figures.hpp"
#include "fdebench/schemes/diagnostics/stability_region.hpp"

namespace fde::bench::figures {
namespace {

constexpr double pi = std::numbers::pi;

void print(const Scheme& scheme, double order, std::string_view line, int piece, double theta,
           ComplexValue z) {
  fmt::print("{},{},{},{},{:.4g},{:.5g},{:.5g}\n", scheme.id, order, line, piece, theta, z.real(), z.imag());
}

void print_boundary(const Scheme& scheme, double order, int points, int& piece) {
  for (const auto& points_of_piece : region_boundary(scheme, order, points)) {
    ++piece;
    for (const auto& [theta, z] : points_of_piece) print(scheme, order, "boundary", piece, theta, z);
  }
}

}  // namespace

void stability_boundaries(const Words& /*words*/) {
  fmt::print("scheme,order,line,piece,theta,re,im\n");
  int piece = 0;
  for (const double order : {0.3, 0.5, 0.7, 1.0, 1.2, 1.5, 1.8}) {
    for (const auto& scheme : schemes()) {
      if (!scheme.symbol || unsupported_reason(scheme, test_problem(scheme, order, -1.0), {})) continue;
      ++piece;
      for (const double r : {0.0, 1000.0})
        print(scheme, order, "sector", piece, r, std::polar(r, 0.5 * pi * order));
      print_boundary(scheme, order, scheme.capabilities.implicit ? 120 : 60, piece);
    }
  }
}

}  // namespace fde::bench::figures
