// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/side_rule.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde {
namespace {

constexpr Eigen::Index steps_between_reports = 1024;

// The matrix stored in a column; the last column is for all later times too.
auto square(const Matrix& columns, Eigen::Index column, std::size_t size) {
  const auto n = static_cast<Eigen::Index>(size);
  return Eigen::Map<const Matrix>(columns.col(std::min(column, columns.cols() - 1)).data(), n, n);
}

}  // namespace

SideRule::SideRule(const Problem& problem, Side side, const WeightFamily& family, const Grid& grid,
                   const Options& options)
    : right_(side == Side::right), grid_(grid), steps_(grid.steps) {
  std::vector<WeightTable> own;
  std::vector<Eigen::Index> algebraic;
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const auto& component = problem.component(i);
    if (component.side != side) continue;
    if (fde::is_algebraic(component)) {
      algebraic.push_back(i);
    } else {
      rows_.push_back(i);
      own.push_back({&family, component.order});
    }
  }
  differential_count_ = static_cast<Eigen::Index>(rows_.size());
  rows_.insert(rows_.end(), algebraic.begin(), algebraic.end());
  const auto size = static_cast<Eigen::Index>(rows_.size());
  mass_.setOnes(size, 2);
  mass_.col(1).tail(size - differential_count_).setZero();
  kappa_.setOnes(size, grid.uniform() ? 2 : steps_ + 1);
  kappa_.col(0).setZero();
  if (differential_count_ == 0) return;
  StepFactors factors(own);
  for (int m = 1; m < kappa_.cols(); ++m) kappa_.col(m).head(differential_count_) = factors.at(grid.step(m));
  history_prototype_ = make_history(options.history, {own}, step_plan(grid), options.newton_tolerance);
}

// Calls step(m, sum, f) for every own time m, with sum the weighted sum of all f before m; step sets f at m.
template <typename Step>
void SideRule::for_each_own_time(Step step) const {
  if (empty()) return;
  const auto history = differential_count_ > 0 ? history_prototype_->copy() : nullptr;
  Vec sum = Vec::Zero(kappa_.rows()), f(kappa_.rows());
  double t = 0.0;
  for (Eigen::Index m = 0; m <= steps_; ++m) {
    if (m % steps_between_reports == 0) report_progress(0);
    if (m > 0 && history) {
      history->push(t, f.head(differential_count_));
      t = time_from_side(m);
      history->convolve(t, 0, sum.head(differential_count_));
    }
    step(m, sum, f);
  }
}

void SideRule::integrate(const Rows& f, Rows& value) const {
  for_each_own_time([&](Eigen::Index m, const Vec& sum, Vec& here) {
    const auto n = grid_index(m);
    here = f.col(n)(rows_);
    value.col(n)(rows_) = mass(m).cwiseProduct(value.col(n)(rows_)) + kappa(m).cwiseProduct(sum + here);
  });
}

void SideRule::solve(const Rows& given, const Matrix& jacobians, const Matrix& inverses, Rows& y) const {
  Vec whole(y.rows()), own(kappa_.rows());
  for_each_own_time([&](Eigen::Index m, const Vec& sum, Vec& f) {
    const auto n = grid_index(m);
    const auto jacobian = square(jacobians, n, static_cast<std::size_t>(y.rows()));
    auto here = y.col(n);
    here(rows_).setZero();
    whole.noalias() = jacobian * here;
    own = given.col(n)(rows_) + kappa(m).cwiseProduct(sum + whole(rows_));
    here(rows_) = square(inverses, m, rows_.size()) * own;
    whole.noalias() = jacobian * here;
    f = whole(rows_);
  });
}

void SideRule::solve_block_diagonal(const Rows& given, const Matrix& inverses, Rows& y) const {
  for (Eigen::Index m = 0; m <= steps_; ++m) {
    const auto n = grid_index(m);
    y.col(n)(rows_) = square(inverses, m, rows_.size()) * given.col(n)(rows_);
  }
}

Matrix SideRule::inverses(const Matrix& jacobians) const {
  const auto size = kappa_.rows();
  Matrix result(size * size, jacobians.cols() == 1 ? kappa_.cols() : steps_ + 1);
  const auto whole = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(jacobians.rows()))));
  for (Eigen::Index m = 0; m < result.cols(); ++m) {
    const Matrix own = square(jacobians, grid_index(m), whole)(rows_, rows_);
    const Matrix system = Matrix(mass(m).asDiagonal()) - kappa(m).asDiagonal() * own;
    Eigen::Map<Matrix>(result.col(m).data(), size, size) = system.inverse();
  }
  return result;
}

}  // namespace fde
