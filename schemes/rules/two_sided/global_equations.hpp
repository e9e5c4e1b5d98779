// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/rules/two_sided/side_rule.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// The unknown initial values of a problem, in the order of its components: value k of component i adds
// value t^k / k! to y_i, t the time of that row; in an algebraic row it counts at t = 0 only.
class UnknownInitialValues {
 public:
  explicit UnknownInitialValues(const Problem& problem);

  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(unknowns_.size()); }

  // Adds to y the terms of these values at a time that is `left` from the start and `right` from the end.
  void add(In values, double left, double right, Out y) const;

 private:
  struct Unknown {
    Eigen::Index component;
    Side side;
    std::size_t power;
    bool algebraic;
  };
  std::vector<Unknown> unknowns_;
};

// A candidate for the solution at all times of a grid.
struct GridFunction {
  Rows y;
  Vec unknown;  // the unknown initial values
};

// The residual of the equations at a guess.
struct Residual {
  Rows rows;       // Taylor part - y + kappa (weighted sum of f), in algebraic rows f
  Vec conditions;  // residual of the problem's conditions
  Rows f;          // f(t, y) of the guess

  // sqrt(sum of rows^2 / number of times + sum of conditions^2).
  [[nodiscard]] double norm() const;
};

// All equations of a two-sided problem, discretised by one integral rule: one for each component at each
// time, and the conditions. The problem must outlive it.
class GlobalEquations {
 public:
  GlobalEquations(const Problem& problem, std::shared_ptr<const Discretisation> discretisation);

  // The same equations on a grid with this number of steps.
  [[nodiscard]] GlobalEquations with_steps(int steps) const;

  // The initial guess: the Taylor part, with 0 for unknown initial values.
  [[nodiscard]] GridFunction initial_guess() const;
  Residual residual(Run& run, const GridFunction& guess) const;

  // The Taylor part of all rows, left and right, at a time at these distances from the start and from the
  // end.
  [[nodiscard]] Vec taylor_part(double left, double right, In unknown) const;

  // Adds to y the terms of the unknown initial values in the Taylor part.
  void add_unknown(In unknown, Rows& y) const;

  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const Discretisation& discretisation() const { return *discretisation_; }
  [[nodiscard]] Eigen::Index times() const { return discretisation_->size(); }  // their number
  [[nodiscard]] const SideRule& left() const { return *discretisation_->left_rule; }
  [[nodiscard]] const SideRule& right() const { return *discretisation_->right_rule; }
  [[nodiscard]] Eigen::Index unknown_count() const { return unknown_.count(); }

 private:
  const Problem& problem_;
  std::shared_ptr<const Discretisation> discretisation_;
  TaylorPart taylor_;
  UnknownInitialValues unknown_;
};

// Newton's linear equations at all times at once. With J_n = df/dy at t_n, K the rules of both sides, B the
// terms of the unknown initial values p and C the derivatives of the conditions with respect to y(0) and
// y(end):
//   x - K J x - B p = r,    C x = c,
// without the x in algebraic rows.
class Linearisation {
 public:
  // The equations must outlive this object.
  explicit Linearisation(const GlobalEquations& equations) : equations_(equations) {}

  // Computes the Jacobians at a guess with this residual.
  void update(Run& run, const GridFunction& guess, const Residual& residual);

  // The left-hand sides for x and p.
  struct LeftHandSides {
    Rows rows;
    Vec conditions;
  };
  [[nodiscard]] LeftHandSides left_hand_sides(const GridFunction& x) const;

  // Replaces y by the solution of y = given + K J y, one side after the other: first the left rows, with the
  // right rows of the y that is passed, then the right rows.
  void forward_backward_sweep(const Rows& given, Rows& y) const;
  // The solution y of the diagonal blocks: without coupling between different times or between the two sides.
  [[nodiscard]] Rows block_diagonal_solution(const Rows& given) const;
  [[nodiscard]] Vec conditions(const Rows& y) const;  // C y
  [[nodiscard]] const Matrix& conditions_by_start() const { return by_start_; }
  [[nodiscard]] const Matrix& conditions_by_end() const { return by_end_; }
  // df/dy at the n-th time.
  [[nodiscard]] Eigen::Map<const Matrix> jacobian(Eigen::Index n) const {
    return jacobian_at_time(jacobians_, n, equations_.problem().size());
  }

  [[nodiscard]] const GlobalEquations& equations() const { return equations_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  void differentiate_conditions(const GridFunction& guess, const Vec& conditions);

  const GlobalEquations& equations_;
  Matrix jacobians_;  // one column a time, or one for all
  std::unique_ptr<const SideFactors> left_{}, right_{};
  Matrix by_start_, by_end_;  // derivatives of the conditions
};

}  // namespace fde
