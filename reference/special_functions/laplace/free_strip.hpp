// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "fdebench/reference/special_functions/laplace/contour_bound.hpp"

namespace fde::reference {

// The parabola s = offset + mu (1 + i theta)^2, offset <= 0: the offset makes it wide in imaginary direction
// while e^s on the real axis stays moderate. Otherwise as ContourShape: |e^(s - offset)| is e^-depth at the
// last node.
struct ShiftedShape {
  double offset, mu, omega, depth;
};

// An a priori bound of the error of the trapezoidal rule on a shifted parabola for
//   F = s^exponent product of (s^alpha - z_i)^-singularity_order_i
// with every singularity left or right of a strip around the contour. No singularity is corrected for: the
// caller has to add the contributions of those on the right. The theorem is the one of ContourBound, between
// the lines Re r = near and Re r = far, r = sqrt((s - offset) / mu). With r_0 = sqrt(-offset / mu) < near,
//   |s| = mu |r - r_0| |r + r_0|
// is between its values on the parabolas without offset for Re r - r_0 and Re r + r_0, and so are the line
// integrals. The distance from s* is
//   |log s - log s*| >= log(1 + |s - s*| / |s*|),  |s - s*| = mu |r - r*| |r + r*| >= mu gap max(gap, |r*|),
// gap = |Re r - Re r*|; for an s* on another sheet it is at least 2 log(1 + gap / |q*|) with
// q = sqrt(s / mu), where Re q >= sqrt((Re r)^2 - r_0^2).
class SingularityFreeStrip {
 public:
  explicit SingularityFreeStrip(const ShiftedShape& shape);

  // (s^alpha - z)^-singularity_order, singularity_order > 0.
  struct Factor {
    double log_size;                              // log|z|
    double nearest_other_argument;                // as in ContourBound::Quotient
    std::span<const std::complex<double>> roots;  // sqrt(s*) for all s* with |arg s*| < 2 pi
    double singularity_order;
  };
  struct Product {
    double exponent, alpha;
    std::span<const Factor> factors;  // by ascending |z|
    // The bound holds for every exponent in [exponent, exponent + exponent_range].
    double exponent_range = 0.0;
    // Lines with smaller bounds are not sought.
    double sufficient_log_bound = -std::numeric_limits<double>::infinity();
  };
  struct Result {
    double log_bound;
    // In the strip the product of |s^alpha - z_i|^singularity_order_i is at least e^log_clearance times the
    // product of max(|s|^alpha, |z_i|)^singularity_order_i.
    double log_clearance;
    double least_size;     // least |s| in the strip
    bool inside, outside;  // whether there are s* on the principal sheet left of the strip, right of it
  };
  // nullopt where an s* is too near the contour for any strip.
  [[nodiscard]] std::optional<Result> bound_for(const Product& product) const;

  // Re r* of s* = root^2.
  [[nodiscard]] double position_of(std::complex<double> root) const;

 private:
  // Re r = distance
  struct Line {
    double distance, log_factor;  // log_factor: of the factor of the integral
    double log_inner, log_outer;  // of the ratios of the integrals with and without offset
    LineIntegrals inner, outer;
  };
  class SingularityPositions;
  struct LineBound {
    double log_bound, log_clearance, distance;
  };
  // The least bound on those of the lines that `admits` takes.
  template <class Admits>
  [[nodiscard]] static LineBound best_line(const std::vector<Line>& lines, const Product& product,
                                           const SingularityPositions& places, const Admits& admits);
  [[nodiscard]] Line line_at(double distance) const;
  [[nodiscard]] static double log_line(const Line& line, const Product& product);
  [[nodiscard]] double log_truncation_error(const Product& product) const;

  ShiftedShape shape_;
  double corner_;  // r_0
  std::vector<Line> near_lines_, far_lines_;
};

}  // namespace fde::reference
