// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/constraint_rank.hpp"

#include <Eigen/LU>
#include <utility>

namespace fde {
namespace {

// The sign of the scalar product of the minors of the gradients at a and of the reactions at b.
int sign_between(const ConstraintMatrices& a, const ConstraintMatrices& b) {
  const double determinant = (a.gradients * b.reactions).determinant();
  return determinant > 0.0 ? 1 : determinant < 0.0 ? -1 : 0;
}

}  // namespace

ConstraintRank::ConstraintRank(const Problem& problem, In start) : problem_(problem), last_(at(0.0, start)) {}

bool ConstraintRank::is_kept_until(double t, In y) {
  State next = at(t, y);
  if (!is_kept_between(last_, next, 0)) return false;
  last_ = std::move(next);
  return true;
}

bool ConstraintRank::is_kept_between(const State& a, const State& b, int halvings) const {
  constexpr int most = 40;
  const int sign = sign_between(a.constraints, a.constraints);
  if (sign != 0 && sign_between(a.constraints, b.constraints) == sign &&
      sign_between(b.constraints, b.constraints) == sign)
    return true;
  if (halvings == most) return false;
  const State middle = at(0.5 * (a.t + b.t), 0.5 * (a.y + b.y));
  return is_kept_between(a, middle, halvings + 1) && is_kept_between(middle, b, halvings + 1);
}

void ConstraintRank::state(Archive& archive) {
  archive(last_.t, last_.y);
  last_ = at(last_.t, last_.y);
}

}  // namespace fde
