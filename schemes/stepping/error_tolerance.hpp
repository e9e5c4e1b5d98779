// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The largest error allowed in each row of a step: atol + rtol |y|, but at most 1/100 of the largest |y| that
// the row has had since t = 0, and at least 50 eps times the terms of the row, and 1e-292. The bound by the
// largest |y| does not hold on the first step of a row that starts from rest, where the error and |y| fall
// with the same power of the step size: at t = 0, where the row was 0 up to now, and after a jump where |y|
// grows a hundredfold.
class ErrorTolerance {
 public:
  explicit ErrorTolerance(const Tolerance& accuracy) : accuracy_(accuracy) {}

  // largest: the largest |y| of each row on the step; terms: the size of the terms that the row is a sum of.
  [[nodiscard]] Vec on_step(In largest, In terms) const { return on_step(largest, largest, terms); }

  // The error allowed at every time of a step on which least <= |y| <= largest. It is relative to `largest`
  // where atol is at most 1e-3 rtol, otherwise to `least`; then the rounding term counts `largest` only up to
  // 16 (atol / rtol + least).
  [[nodiscard]] Vec on_step(In least, In largest, In terms) const {
    return on_step(least, largest, terms, Vec::Zero(largest.size()));
  }

  // The same, where the bound by the largest |y| is at least `unresolved`: errors of the rows that no step
  // size makes smaller (RhsError).
  [[nodiscard]] Vec on_step(In least, In largest, In terms, In unresolved) const;

  // The allowed error without the bound by the largest |y| so far.
  [[nodiscard]] Vec from_tolerance(In largest, In terms) const;

  // The largest error of Problem::outputs, in units of the tolerance, if y(t) has these errors. Those within
  // the rounding errors of a row with these terms do not count.
  [[nodiscard]] double error_of_outputs(const Problem& problem, double t, In y, In errors, In terms) const;

  // Records an accepted step with the largest |y| of each row on it.
  void accept_step(In largest);

  // The next step is the first after a jump.
  void restart() { after_jump_ = true; }

  void state(Archive& archive) {
    archive.resizable(largest_);
    archive(after_jump_);
  }

 private:
  Tolerance accuracy_;
  Vec largest_;  // over all accepted steps; empty before the first
  bool after_jump_ = false;
};

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
