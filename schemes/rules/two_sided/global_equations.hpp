// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/rules/two_sided/side_rule.hpp"

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
// time, and the conditions. Problem, options and family must outlive it.
class GlobalEquations {
 public:
  GlobalEquations(const Problem& problem, const Grid& grid, const Options& options,
                  const WeightFamily& family);

  // The same equations on a grid with this number of steps.
  [[nodiscard]] GlobalEquations with_steps(int steps) const;

  // The initial guess: the Taylor part, with 0 for unknown initial values.
  [[nodiscard]] GridFunction initial_guess() const;
  Residual residual(Run& run, const GridFunction& guess) const;

  // Adds to y the terms of the unknown initial values in the Taylor part.
  void add_unknown(In unknown, Rows& y) const;

  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] const SideRule& left() const { return left_; }
  [[nodiscard]] const SideRule& right() const { return right_; }
  [[nodiscard]] Eigen::Index unknown_count() const { return unknown_.count(); }

 private:
  const Problem& problem_;
  const Options& options_;
  const WeightFamily& family_;
  Grid grid_;
  SideRule left_, right_;
  UnknownInitialValues unknown_;
};

}  // namespace fde
