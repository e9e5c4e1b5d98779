#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fde {

// The right-hand side of a step from y_(n-1) to y_n, row i taken between the two, at
//   t* = t_(n-1) + offset_i (t_n - t_(n-1)),   y* = y_(n-1) + offset_i (y_n - y_(n-1)):
// a problem in y_n, which is evaluated once for each offset. Where all are 1 it is the given one.
class BetweenSteps {
 public:
  // The problem lives longer.
  BetweenSteps(const Problem& problem, const Vec& offsets);
  BetweenSteps(const BetweenSteps&) = delete;
  BetweenSteps& operator=(const BetweenSteps&) = delete;

  // Reads the step from here.
  [[nodiscard]] const Problem& problem() const { return stepped_; }

  // The step that the problem speaks of from now on.
  void step_from(double t, In y, double length);

  // How often the right-hand side is evaluated for one of problem().
  [[nodiscard]] int evaluations() const { return static_cast<int>(groups_.size()); }

 private:
  struct Group {
    double offset;
    Vec rows;  // 1 in its rows, 0 elsewhere
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
