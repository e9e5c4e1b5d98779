// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// Detects that the constraints of a problem (Domain::constraints) lose their rank within a step: what follows
// would be unrelated to the motion. With A the gradients and Q the reactions, det(A(a) Q(b)) is the scalar
// product of the vectors of minors of A at a state a and of Q at a state b (Cauchy & Binet). On a step whose
// minors turn by less than a right angle it has one sign for all pairs of states. Where a step has two signs,
// it is halved along the straight line between its ends. If the signs stay two down to the shortest part, the
// minors pass through 0.
class ConstraintRank {
 public:
  // Precondition: problem.domain.constraints is not empty.
  ConstraintRank(const Problem& problem, In start);

  // Whether the rank is kept from the last state to this one, which is then the last.
  bool is_kept_until(double t, In y);

  void state(Archive& archive);

 private:
  struct State {
    double t;
    Vec y;
    ConstraintMatrices constraints;
  };
  [[nodiscard]] State at(double t, In y) const { return {t, y, problem_.domain.constraints(t, y)}; }
  [[nodiscard]] bool is_kept_between(const State& a, const State& b, int halvings) const;

  const Problem& problem_;
  State last_;
};

}  // namespace fde
