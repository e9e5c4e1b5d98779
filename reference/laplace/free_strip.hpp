#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "laplace/contour_bound.hpp"

namespace fde {

// The parabola s = offset + mu (1 + i theta)^2, offset <= 0: with the offset it reaches far up without rising
// high on the real axis. Otherwise as ContourShape: e^(s - offset) is down to e^-depth at the last node.
struct ShiftedShape {
  double offset, mu, omega, depth;
};

// A bound, by theory, of what the trapezoidal rule on a shifted parabola neglects for
//   F = s^exponent product of (s^alpha - z_i)^-strength_i
// with every singularity left or right of a strip round the contour: none is corrected for, and of what is
// right of it the caller has to say what it contributes. The theorem is that of ContourBound, between the
// lines Re r = near and Re r = far, r = sqrt((s - offset) / mu). With r_0 = sqrt(-offset / mu) < near,
//   |s| = mu |r - r_0| |r + r_0|
// is between what it is on the parabolas without offset that belong to Re r - r_0 and to Re r + r_0. So are
// the line integrals. The distance of s* is
//   |log s - log s*| >= log(1 + |s - s*| / |s*|),  |s - s*| = mu |r - r*| |r + r*| >= mu gap max(gap, |r*|),
// gap = |Re r - Re r*|; of an s* on another sheet 2 log(1 + gap / |q*|) with q = sqrt(s / mu), where
// Re q >= sqrt((Re r)^2 - r_0^2).
class FreeStrip {
 public:
  explicit FreeStrip(const ShiftedShape& shape);

  // (s^alpha - z)^-strength, strength > 0.
  struct Factor {
    double log_size;                              // of z
    double nearest_sheet;                         // as in ContourBound
    std::span<const std::complex<double>> roots;  // sqrt(s*) for all s* with |arg s*| < 2 pi
    double strength;
  };
  struct Product {
    double exponent, alpha;
    std::span<const Factor> factors;  // by size of z, the least one first
    double more = 0.0;                // the bound is one for every exponent up to so much above this one
  };
  struct Result {
    double log_bound;
    double log_clearance;  // |s^alpha - z_i| in the strip is at least max(|s|^alpha, |z_i|) times factors
                           // whose product, to the power of their strengths, has this logarithm
    double least_size;     // of s in the strip
    bool inside, outside;  // there are s* on the principal sheet left of the strip, right of it
  };
  // Empty where an s* is too near the contour for any strip.
  [[nodiscard]] std::optional<Result> at(const Product& product) const;

  // Re r of an s* given by its root.
  [[nodiscard]] double place_of(std::complex<double> root) const;

 private:
  // Re r = distance
  struct Line {
    double distance, log_factor;  // what the integral is multiplied with
    double log_inner, log_outer;  // of the ratios of the integrals to those without offset
    LineIntegrals inner, outer;
  };
  class Places;
  [[nodiscard]] Line line_at(double distance) const;
  [[nodiscard]] static double log_line(const Line& line, const Product& product);
  [[nodiscard]] double log_left_out(const Product& product) const;

  ShiftedShape shape_;
  double corner_;  // r_0
  std::vector<Line> near_lines_, far_lines_;
};

}  // namespace fde
