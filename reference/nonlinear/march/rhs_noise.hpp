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

// y and the returned f have one row per time.
Matrix rhs_at(const Problem& problem, const Vec& times, const Matrix& y);

// The largest change of each f_i when the times are moved by their last digit towards `from`: a rounding
// error of f that a steep load has.
Vec rounding_of_times(const Problem& problem, double from, const Vec& times, const Matrix& y,
                      const Matrix& rhs);

// The largest |f_i| at the initial values over [0, end], where step limits show that it changes quickly and
// elsewhere: rounding errors of f have this size also where f is small, as 1 - cos t near 0 and a pulse
// before it begins.
Vec largest_forcing(const Problem& problem);

}  // namespace fde::reference
