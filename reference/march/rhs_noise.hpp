#pragma once

#include "problem/problem.hpp"

namespace fde {

// How large rounding is in each f_i between two states: differences of high order of f along the straight
// line, where all that is smooth disappears (after More & Wild, SIAM J. Sci. Comput. 33, 2011). The last
// digit of y varies at random, so that rounding shows where y hardly moves. It shows terms that cancel for
// every y, of which neither f nor df/dy tells. 0 where f is not finite.
Vec rhs_noise(const Problem& problem, double from, In y_from, double to, In y_to);

// What is known of the rounding of f, for a march that finds out on the way.
class RhsNoise {
 public:
  explicit RhsNoise(const Problem& problem) : problem_(problem), found_(Vec::Zero(problem.size())) {}

  // An allowance for each f_i: 0, or twice the noise.
  [[nodiscard]] const Vec& found() const { return found_; }

  // Looks between neighbours among states, a row of y each, where a tail of some f_i is unresolved by more
  // than is negligible. True if it has noise that is news and explains the tail. Noise is small beside the
  // scale, the largest size of a component of y or f: what is larger is a jump.
  bool find(const Vec& times, const Matrix& y, In unresolved, In negligible, double scale);

  // After a step: noise that is known may fade, like that of a factor t^-1/2, into what the sizes of f and of
  // its terms explain.
  void follow(const Vec& times, const Matrix& y, In explained);

 private:
  // The largest between neighbours, not all of them.
  [[nodiscard]] Vec largest(const Vec& times, const Matrix& y) const;

  const Problem& problem_;
  Vec found_;
};

}  // namespace fde
