// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

// Newton's linear equations of the rows of one side for given Jacobians J,
//   mass y_m = given_m + kappa (weighted sum of g), g = J y, mass and kappa as in SideRule.
class SideFactors {
 public:
  SideFactors() = default;
  virtual ~SideFactors() = default;
  SideFactors& operator=(SideFactors&&) = delete;

  // Solves them, one own time after another; y contains the rows of the other side.
  virtual void solve(const Rows& given, Rows& y) const = 0;

  // The same without the sums over other times.
  virtual void solve_block_diagonal(const Rows& given, Rows& y) const = 0;

  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

// The integral rule of the rows of one side, at all times at once. It is written in the rows' own time: the
// time from the start for left rows, the time left until the end for right rows, where the m-th own time is
// the m-th from the end. There y_m = Taylor part + kappa (weighted sum of f), with kappa = 0 at the start.
//
// An algebraic row reads 0 = f_m instead and enters no sum; at its start it has its initial value.
//
// Values have one row a component of the whole problem, one column a time; only the rows of this side are
// changed.
class SideRule {
 public:
  SideRule(const Problem& problem, Side side);
  virtual ~SideRule() = default;
  SideRule& operator=(SideRule&&) = delete;

  [[nodiscard]] const std::vector<Eigen::Index>& rows() const { return rows_; }
  [[nodiscard]] bool empty() const { return rows_.empty(); }

  // value = mass value + kappa (weighted sum of f). mass is 1, and 0 in algebraic rows, which become f.
  virtual void integrate(const Rows& f, Rows& value) const = 0;

  // jacobians: one column a time, or one for all times. They and this object must outlive the factors.
  [[nodiscard]] virtual std::unique_ptr<SideFactors> factors(const Matrix& jacobians) const = 0;

  // Of the kind of history; empty: there is none.
  [[nodiscard]] virtual std::optional<ChosenHistory> history() const { return {}; }
  [[nodiscard]] virtual std::size_t bytes() const = 0;

 protected:
  bool right_;
  std::vector<Eigen::Index> rows_{};     // those with a sum, then the algebraic ones
  Eigen::Index differential_count_ = 0;  // how many have one
};

// The Jacobian at a time, from jacobians with one column a time or one for all times.
Eigen::Map<const Matrix> jacobian_at_time(const Matrix& jacobians, Eigen::Index time, Eigen::Index size);

// A discretisation of a two-sided problem: its times, as distances from the start and from the end, and the
// rules of both sides.
struct Discretisation {
  Vec left, right;
  std::shared_ptr<const SideRule> left_rule, right_rule;
  // A coarse one, on a grid with this number of steps.
  std::function<std::shared_ptr<const Discretisation>(int steps)> with_steps;

  [[nodiscard]] Eigen::Index size() const { return left.size(); }
};

}  // namespace fde
