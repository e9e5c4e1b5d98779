// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Estimates the errors of f(t, y), one a row, that no step size makes smaller. They are 0 until the first
// measure().
class RhsError {
 public:
  explicit RhsError(Eigen::Index rows) : rounding_(Vec::Zero(rows)), inherited_(rounding_) {}

  // Estimates them at y from some values of f at one time. permitted: the errors of y. As a few trials may
  // miss the largest errors, half of the last estimate counts too.
  void measure(const std::function<const Vec&(In y)>& f, In y, In permitted);

  [[nodiscard]] bool is_measured() const { return is_measured_; }

  // The rounding errors of f: ten times its largest change where y changes by few units in the last place,
  // which also shows terms of f that cancel (More & Wild, SIAM J. Sci. Comput. 33 (2011)).
  [[nodiscard]] const Vec& rounding() const { return rounding_; }

  // These, or the errors of f_i from errors of the other rows as large as permitted, whichever are larger.
  [[nodiscard]] Vec all() const { return rounding_.cwiseMax(inherited_); }

  void state(Archive& archive) { archive(is_measured_, rounding_, inherited_); }

 private:
  bool is_measured_ = false;
  Vec rounding_, inherited_;
};

}  // namespace fde
