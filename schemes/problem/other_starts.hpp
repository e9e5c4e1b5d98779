#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fde {

// A smooth candidate for the solution of a two-sided problem,
//   y_i(t) = Taylor part + sum_(j=0)^3 a_ij cos(j pi t / end).
// Newton's method begins from such where it does not converge from the Taylor part.
class SmoothStart {
 public:
  SmoothStart(const Problem& problem, Matrix amplitudes);
  [[nodiscard]] Vec at(double t) const;

 private:
  double end_;
  TaylorPart taylor_;
  std::vector<Side> sides_;
  Matrix amplitudes_;  // a_ij: one row a component, one column a frequency
};

// So many of them, with amplitudes from 1/4 to 8 of either sign. They are the same at each call.
std::vector<SmoothStart> other_starts(const Problem& problem, int count);

}  // namespace fde
