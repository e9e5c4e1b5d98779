// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// A problem in y_n whose right-hand side f_i is evaluated within the step from y_(n-1) to y_n, at
//   t* = t_(n-1) + offset_i (t_n - t_(n-1)),   y* = y_(n-1) + offset_i (y_n - y_(n-1)).
// The given right-hand side is called once for each distinct offset. If all offsets are 1 it is the given
// problem.
class OffStepProblem {
 public:
  // `problem` must outlive this object. One offset a component.
  OffStepProblem(const Problem& problem, const Vec& offsets);
  OffStepProblem(const OffStepProblem&) = delete;
  OffStepProblem& operator=(const OffStepProblem&) = delete;

  // The problem in y_n. It refers to this object, which must outlive it.
  [[nodiscard]] const Problem& problem() const { return stepped_; }

  // Sets the step of problem(): t_(n-1) = t, y_(n-1) = y, step size `length`.
  void set_step(double t, In y, double length);

  // The number of calls of the given right-hand side for one call of problem().rhs.
  [[nodiscard]] int evaluations() const { return static_cast<int>(groups_.size()); }

 private:
  struct Group {
    double offset;
    Vec rows;  // 1 in the rows with this offset, 0 elsewhere
  };
  [[nodiscard]] Derivatives derivatives() const;
  [[nodiscard]] double time(const Group& group) const { return before_ + group.offset * length_; }
  [[nodiscard]] Vec between(const Group& group, In y) const { return start_ + group.offset * (y - start_); }
  void evaluate(In y, Out f) const;
  void differentiate(In y, OutMatrix jacobian) const;
  void differentiate_sparse(In y, SparseMatrix& jacobian) const;

  const Problem& problem_;
  Vec offsets_;
  std::vector<Group> groups_;
  double before_ = 0.0, length_ = 0.0;
  Vec start_;
  Problem stepped_;
};

}  // namespace fde
