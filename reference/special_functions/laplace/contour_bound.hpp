// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <limits>
#include <span>
#include <vector>

namespace fde::reference {

// The parameters of the parabola of contour.hpp in double, for bounds.
struct ContourShape {
  double mu, omega, depth;
  bool half_step_shift;

  [[nodiscard]] double step() const;
  [[nodiscard]] double nearer_far_line() const { return omega / (4.0 * mu); }
  // Distance of the point theta of a pole, root = 1 + i theta, from the nearest node, in steps: the larger of
  // the two coordinates.
  [[nodiscard]] double steps_to_node(std::complex<double> root) const;
};

// log of an upper bound of (1/2 pi) int |e^s s^exponent ds| along s = mu (distance + i x)^2, all real x.
double log_line_integral(double mu, double distance, double exponent);

// The same from a table over integer exponents: the integral is log-convex in the exponent, so that linear
// interpolation of its logarithm is an upper bound.
class LineIntegrals {
 public:
  LineIntegrals(double mu, double distance);
  [[nodiscard]] double log_at(double exponent) const;

 private:
  double mu_, distance_;
  std::vector<double> logs_;
};

// An a priori bound of the error of the trapezoidal rule on a contour for F = s^exponent / (s^alpha - z).
//
// Between the lines Im theta = 1 - d and Im theta = 1 - b, b = omega / (2 mu) or omega / (4 mu), the sum with
// the residues of the poles in between differs from f by at most (Trefethen & Weideman, SIAM Review 56, 2014,
// theorem 5.1)
//   I(d) / (e^(omega (1-d)) - 1) + I(b) / (e^(omega (b-1)) - 1),  I = (1/2 pi) int |e^s F ds| on the line,
// plus the truncated nodes. With u = alpha (log s - log s*) the denominator is bounded from below by
//   |s^alpha - z| = |z| |e^u - 1| >= max(|s|^alpha, |z|) min(1, |u mod 2 pi i|) / 10,
// and |log s - log s*| >= 2 log(1 + |r - r*| / |r*|), r = sqrt(s / mu) = 1 + i theta, as
// |e^x - 1| <= e^|x| - 1.
class ContourBound {
 public:
  explicit ContourBound(const ContourShape& shape);

  struct Quotient {
    double exponent, alpha, log_size;             // log_size = log|z|
    double nearest_other_argument;                // least |arg z + 2 pi k| of the poles that are not in roots
    std::span<const std::complex<double>> roots;  // r* = sqrt(s* / mu) of the poles with |arg s*| < 2 pi
  };
  struct Result {
    double log_bound;
    double distance;  // d: the poles with Re root > d are those between the lines
  };
  [[nodiscard]] Result bound_for(const Quotient& quotient) const;

  // log of a bound of (1/2 pi) int |e^s F ds| along the whole line s = mu (distance + i x)^2: a bound of f
  // minus the residues of the poles with Re root > distance.
  [[nodiscard]] static double log_integral(double mu, double distance, const Quotient& quotient);

  // Whether the residue of the pole counts: the pole is between the lines, or right of the second one, where
  // the exact factor is 1 and the computed one nearly so.
  [[nodiscard]] static bool includes_residue(std::complex<double> root, double distance) {
    return root.real() > distance;
  }

 private:
  // s = mu (distance + i x)^2
  struct Line {
    double distance, log_factor;  // log_factor: of the factor of the integral
    LineIntegrals integrals;
  };
  [[nodiscard]] double log_line(const Line& at, const Quotient& quotient) const;
  [[nodiscard]] double log_truncation_error(const Quotient& quotient) const;

  ContourShape shape_;
  std::vector<Line> near_lines_, far_lines_;
};

}  // namespace fde::reference
