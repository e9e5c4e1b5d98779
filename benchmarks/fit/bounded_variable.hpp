// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/text/range.hpp"

namespace fde::bench {

// A parameter theta in a range as a function of a free variable z, so that a minimiser without bounds stays
// within the range: theta = unit z without bounds, low + unit e^z, high - unit e^-z, or
// low + (high - low) / (1 + e^-z). The unit is a usual size of theta.
class BoundedVariable {
 public:
  BoundedVariable(const Range& range, double unit) : range_(range), unit_(unit) {}

  // Whether theta is inside the range, where z is finite.
  [[nodiscard]] bool has_inside(double theta) const;
  // Precondition: has_inside(theta).
  [[nodiscard]] double free(double theta) const;
  [[nodiscard]] double bounded(double z) const;
  [[nodiscard]] double slope(double z) const;  // d theta / dz
  [[nodiscard]] bool has_bound() const { return has_low() || has_high(); }

  // The nearer end of the range, or what is next to it inside where the end itself is excluded. Precondition:
  // the range has a bound.
  [[nodiscard]] double nearest_end(double theta) const;
  // The range's width; the unit where the width is infinite or larger.
  [[nodiscard]] double width() const;

 private:
  [[nodiscard]] bool has_low() const;
  [[nodiscard]] bool has_high() const;

  Range range_;
  double unit_;
};

}  // namespace fde::bench
