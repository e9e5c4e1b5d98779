// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// The rounding noise of each f_i between two states, from high differences of f along the straight line
// between them, in which smooth functions vanish (after More & Wild, SIAM J. Sci. Comput. 33, 2011). The last
// digit of y is varied at random, so that noise appears also where y hardly changes. The noise includes the
// rounding of terms that cancel for every y, which neither f nor df/dy shows. 0 where f is not finite.
Vec rhs_noise(const Problem& problem, double from, In y_from, double to, In y_to);

// The rounding noise of f, estimated during the integration.
class RhsNoise {
 public:
  explicit RhsNoise(const Problem& problem) : problem_(problem), allowance_(Vec::Zero(problem.size())) {}

  // An allowance for each f_i: 0, or twice the noise.
  [[nodiscard]] const Vec& allowance() const { return allowance_; }

  // Measures noise between neighbouring states (one row of y for each of `times`) if some f_i has an
  // unresolved tail above `negligible`. True if new noise is found that explains the tail. Only noise small
  // compared with scale, the largest size of a component of y or f, counts: anything larger is a jump.
  bool detect(const Vec& times, const Matrix& y, In unresolved, In negligible, double scale);

  // To be called after each step: reduces the known noise where it has decayed (as with a factor t^-1/2) to
  // what the sizes of f and of its terms explain.
  void update_after_step(const Vec& times, const Matrix& y, In explained);

 private:
  // The largest noise over a sample of the pairs of neighbours.
  [[nodiscard]] Vec largest(const Vec& times, const Matrix& y) const;

  const Problem& problem_;
  Vec allowance_;
};

}  // namespace fde::reference
