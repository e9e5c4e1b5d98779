// Where the regions of linear stability end. CSV, one row a point of the boundary:
//
//   scheme, order    z = lambda h^order of D^order y = lambda y
//   line             boundary, or sector for the rays |arg z| = order pi/2 of the exact equation
//   piece            points of one piece are joined, in this order
//   theta            a mode stands at exp(i theta) there, or at exp(-i theta) for the conjugate of z
//   re, im           z. Of the curves on which a mode stands on the unit circle only what divides stable from
//                    unstable is printed

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problem/scalar_equation.hpp"
#include "programs/stability/across.hpp"
#include "stability/stability_region.hpp"

namespace {

using namespace fde;
constexpr double pi = std::numbers::pi;

// Whether stability ends on the curve at z, its value at this theta.
bool divides(const Scheme& scheme, double order, double theta, ComplexValue z) {
  const ComplexValue out = across(scheme, order, theta, z, 1e-3);
  const auto is_stable = [&](ComplexValue at) { return stable(scheme, scalar_equation(order, at), 1.0); };
  return is_stable(z + out) != is_stable(z - out);
}

void print(const Scheme& scheme, double order, std::string_view line, int piece, double theta,
           ComplexValue z) {
  fmt::print("{},{},{},{},{:.4g},{:.5g},{:.5g}\n", scheme.id, order, line, piece, theta, z.real(), z.imag());
}

// The angles, denser at both ends.
double angle(double f) { return pi * f * f * f * (4.0 - 3.0 * f) + 1e-6 * (1.0 - f); }

// The last angle of a piece, between one inside it and one outside, by bisection; z, the value inside,
// becomes that of the result.
double end_of_piece(const Scheme& scheme, double order, double inside, double outside, ComplexValue& z) {
  for (int halving = 0; halving < 8; ++halving) {
    const double middle = 0.5 * (inside + outside);
    const ComplexValue there = nearest(boundary(scheme, order, middle), z);
    if (divides(scheme, order, middle, there)) {
      inside = middle;
      z = there;
    } else {
      outside = middle;
    }
  }
  return inside;
}

// One curve, from a root at the last angle, zeta = -1, down to zeta = 1.
void print_curve(const Scheme& scheme, double order, int points, ComplexValue z, int& piece) {
  bool inside = false;  // a piece
  for (int i = points; i >= 0; --i) {
    const double theta = angle(static_cast<double>(i) / points), last = angle((i + 1.0) / points);
    const ComplexValue before = z;
    z = nearest(boundary(scheme, order, theta), z);
    const bool divided = scheme.needs.implicit || divides(scheme, order, theta, z);
    if (divided && !inside) ++piece;
    if (divided != inside && i < points) {
      ComplexValue end = divided ? z : before;
      const double at = divided ? end_of_piece(scheme, order, theta, last, end)
                                : end_of_piece(scheme, order, last, theta, end);
      print(scheme, order, "boundary", piece, at, end);
    }
    if (divided) print(scheme, order, "boundary", piece, theta, z);
    inside = divided;
  }
}

void print_boundary(const Scheme& scheme, double order, int points, int& piece) {
  const auto roots = boundary(scheme, order, pi);
  for (const ComplexValue z : roots) print_curve(scheme, order, points, z, piece);
}

}  // namespace

int main() try {
  fmt::print("scheme,order,line,piece,theta,re,im\n");
  int piece = 0;
  for (const double order : {0.3, 0.5, 0.7, 1.0, 1.2, 1.5, 1.8}) {
    for (const auto& scheme : schemes()) {
      ++piece;
      for (const double r : {0.0, 1000.0})
        print(scheme, order, "sector", piece, r, std::polar(r, 0.5 * pi * order));
      print_boundary(scheme, order, scheme.needs.implicit ? 120 : 60, piece);
    }
  }
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "fde_stability_boundaries: {}\n", error.what());
  return 1;
}
