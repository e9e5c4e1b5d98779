// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// The integral rule of the rows of one side, at all times at once. It is written in the rows' own time: the
// time of the grid for left rows, the time left until its end for right rows. There it is the rule of the
// stepping schemes: y_m = Taylor part + kappa (weighted sum of f_0 ... f_m). So the matrix of the right rule
// is that of the left one with rows and columns in reverse order.
//
// An algebraic row reads 0 = f_m instead and enters no sum; at its start it has its initial value.
//
// Values have one row a component of the whole problem, one column a time of the grid; only the rows of this
// side are changed.
class SideRule {
 public:
  // Precondition: the grid is uniform if the side is right.
  SideRule(const Problem& problem, Side side, const WeightFamily& family, const Grid& grid,
           const Options& options);

  [[nodiscard]] const std::vector<Eigen::Index>& rows() const { return rows_; }
  [[nodiscard]] bool empty() const { return rows_.empty(); }

  // The index in the grid of the m-th own time.
  [[nodiscard]] Eigen::Index grid_index(Eigen::Index m) const { return right_ ? steps_ - m : m; }
  // The m-th own time, measured from the start of the rows.
  [[nodiscard]] double time_from_side(Eigen::Index m) const { return grid_.time(static_cast<int>(m)); }

  // value = mass value + kappa (weighted sum of f). mass is 1, and 0 in algebraic rows, which become f.
  void integrate(const Rows& f, Rows& value) const;

  // Solves mass y_m = given_m + kappa (weighted sum of g), g = J y, for the rows of this side, step after
  // step of own time; y contains those of the other side. jacobians: one column a time, or one for all times;
  // inverses likewise, from inverses().
  void solve(const Rows& given, const Matrix& jacobians, const Matrix& inverses, Rows& y) const;

  // The same without the sums over other times.
  void solve_block_diagonal(const Rows& given, const Matrix& inverses, Rows& y) const;

  // (mass - kappa J)^-1, J restricted to the rows of this side, one column an own time: two where steps and
  // Jacobians are all equal, the first for the start.
  [[nodiscard]] Matrix inverses(const Matrix& jacobians) const;

  // Of the kind of history; empty: there are no sums.
  [[nodiscard]] std::string_view history_kind_name() const {
    return history_prototype_ ? name(history_prototype_->kind()) : std::string_view();
  }
  [[nodiscard]] std::size_t bytes() const { return history_prototype_ ? history_prototype_->bytes() : 0; }

 private:
  template <typename Step>
  void for_each_own_time(Step step) const;

  [[nodiscard]] auto mass(Eigen::Index m) const { return mass_.col(m > 0 ? 1 : 0); }
  [[nodiscard]] auto kappa(Eigen::Index m) const { return kappa_.col(std::min(m, kappa_.cols() - 1)); }

  bool right_;
  Grid grid_;
  Eigen::Index steps_;
  std::vector<Eigen::Index> rows_;       // those with a sum, then the algebraic ones
  Eigen::Index differential_count_ = 0;  // how many have one
  Matrix mass_;                          // at the start, later
  Matrix kappa_;                         // one column an own time, 0 at the start; on uniform grids two
  std::unique_ptr<History> history_prototype_;  // copied for each pass over the own times
};

}  // namespace fde
