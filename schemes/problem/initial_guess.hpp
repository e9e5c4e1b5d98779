// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// A smooth initial guess for Newton's method in a two-sided problem,
//   y_i(t) = Taylor part + sum_(j=0)^3 a_ij cos(j pi t / end),
// used where Newton's method does not converge from the Taylor part.
class InitialGuess {
 public:
  InitialGuess(const Problem& problem, Matrix amplitudes);
  [[nodiscard]] Vec at(double t) const;

 private:
  double end_;
  TaylorPart taylor_;
  std::vector<Side> sides_;
  Matrix amplitudes_;  // a_ij: one row a component, one column a frequency
};

// `count` initial guesses with pseudo-random a_ij, uniform in [-A, A) with A from 1/4 to 8 in turn. Every
// call returns the same ones.
std::vector<InitialGuess> initial_guesses(const Problem& problem, int count);

}  // namespace fde
