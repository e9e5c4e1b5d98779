// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/stepping/run.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// An interpolant of y on a grid, whose Caputo derivative a rule evaluates, for each component i, at
// t* = t_(n-1) + offset_i (t_n - t_(n-1)):
//   D^g_i y_i(t*) = known_i + newest_i (y_n - y_(n-1))_i.
class Interpolant {
 public:
  Interpolant& operator=(Interpolant&&) = delete;
  virtual ~Interpolant() = default;

  [[nodiscard]] virtual Vec offsets() const = 0;

  // The coefficients `known` and `newest` of step n. Precondition: push was called for all earlier steps.
  virtual void derivative(int n, Out known, Out newest) = 0;

  // Appends the increment y_n - y_(n-1). Not needed after the last step.
  virtual void push(int n, In increment) = 0;

  [[nodiscard]] virtual std::size_t bytes() const = 0;
  [[nodiscard]] virtual ChosenHistory history() const = 0;

  // Archives the state that depends on the increments.
  virtual void state(Archive& archive) = 0;
};

// Solves D^g_i y_i(t*) = f_i(t*, y*) at every step of the grid, y* on the line from y_(n-1) to y_n, by
// Newton's method. Precondition: no row is algebraic.
Trajectory solve_with_interpolant(Interpolant& interpolant, const Problem& problem, const Grid& grid,
                                  const Options& options);

// The Caputo derivative of an interpolant whose slope on each step is determined by one sample, by a family
// of weights for increments. Times as in History.
class SlopeHistory {
 public:
  SlopeHistory(const std::vector<WeightTable>& tables, const StepPlan& steps, const Options& options);

  void push(double t, In sample);

  // The contribution of all samples to the derivative at a time t after the newest.
  void derivative(double t, Out result);

  [[nodiscard]] std::size_t bytes() const { return history_->bytes(); }
  [[nodiscard]] ChosenHistory history() const { return history_->chosen(); }

  void state(Archive& archive) { archive(newest_, history_); }

 private:
  StepPlan steps_;
  double newest_ = 0.0;  // time of the newest sample
  StepFactors factors_;
  std::unique_ptr<History> history_;
};

// A problem in y_n whose right-hand side f_i is evaluated within the step from y_(n-1) to y_n, at
//   t* = t_(n-1) + offset_i (t_n - t_(n-1)),   y* = y_(n-1) + offset_i (y_n - y_(n-1)).
// The given right-hand side is called once for each distinct offset. If all offsets are 1 it is the given
// problem.
class OffStepProblem {
 public:
  // `problem` must outlive this object. One offset a component.
  OffStepProblem(const Problem& problem, const Vec& offsets);
  OffStepProblem& operator=(OffStepProblem&&) = delete;

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
