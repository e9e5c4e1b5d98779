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
#include <array>
#include <cmath>
#include <numbers>

#include "stability_region.hpp"

namespace {

using namespace fde;
constexpr double pi = std::numbers::pi;

bool divides(const Scheme& scheme, double order, ComplexValue z) {
  constexpr double aside = 1e-3;
  // Across the curve, whichever way it runs.
  const ComplexValue out = std::polar(aside * std::abs(z), 0.3 + std::arg(z));
  const auto is_stable = [&](ComplexValue at) { return stable(scheme, scalar_equation(order, at), 1.0); };
  const bool there = is_stable(z + out);
  constexpr std::array<ComplexValue, 3> turns{{{-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}};
  return std::ranges::any_of(turns, [&](ComplexValue turn) { return is_stable(z + turn * out) != there; });
}

void print(const Scheme& scheme, double order, std::string_view line, int piece, double theta,
           ComplexValue z) {
  fmt::print("{},{},{},{},{:.4g},{:.5g},{:.5g}\n", scheme.id, order, line, piece, theta, z.real(), z.imag());
}

// The angles, denser at both ends.
double angle(double f) { return pi * f * f * f * (4.0 - 3.0 * f) + 1e-6 * (1.0 - f); }

// The root of the boundary that continues z.
ComplexValue nearest(const std::vector<ComplexValue>& roots, ComplexValue z) {
  return std::ranges::min(roots, {}, [&](ComplexValue root) { return std::abs(root - z); });
}

// One curve, from a root at the last angle, zeta = -1, down to zeta = 1.
void print_curve(const Scheme& scheme, double order, int points, ComplexValue z, int& piece) {
  bool inside = false;  // a piece
  for (int i = points; i >= 0; --i) {
    const double theta = angle(static_cast<double>(i) / points);
    const ComplexValue before = z;
    z = nearest(boundary(scheme, order, theta), z);
    const bool divided = scheme.needs.implicit || divides(scheme, order, z);
    if (divided != inside && i < points) {
      double in = divided ? theta : angle((i + 1.0) / points),
             out = divided ? angle((i + 1.0) / points) : theta;
      ComplexValue end = divided ? z : before;
      for (int halving = 0; halving < 8; ++halving) {
        const double middle = 0.5 * (in + out);
        const ComplexValue there = nearest(boundary(scheme, order, middle), end);
        if (divides(scheme, order, there)) {
          in = middle;
          end = there;
        } else {
          out = middle;
        }
      }
      if (divided) ++piece;
      print(scheme, order, "boundary", piece, in, end);
    } else if (divided && !inside) {
      ++piece;
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
