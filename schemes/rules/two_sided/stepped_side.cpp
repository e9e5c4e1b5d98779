// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/stepped_side.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde {
namespace {

constexpr Eigen::Index steps_between_reports = 1024;

}  // namespace

class SteppedSide::Factors final : public SideFactors {
 public:
  Factors(const SteppedSide& side, const Matrix& jacobians)
      : side_(side), jacobians_(jacobians), inverses_(side.inverses(jacobians)) {}

  void solve(const Rows& given, Rows& y) const override {
    const auto& rows = side_.rows_;
    Vec whole(y.rows()), own(side_.kappa_.rows());
    side_.for_each_own_time([&](Eigen::Index m, const Vec& sum, Vec& f) {
      const auto n = side_.grid_index(m);
      const auto jacobian = jacobian_at_time(jacobians_, n, y.rows());
      auto here = y.col(n);
      here(rows).setZero();
      whole.noalias() = jacobian * here;
      own = given.col(n)(rows) + side_.kappa(m).cwiseProduct(sum + whole(rows));
      here(rows) = inverse(m) * own;
      whole.noalias() = jacobian * here;
      f = whole(rows);
    });
  }

  void solve_block_diagonal(const Rows& given, Rows& y) const override {
    const auto& rows = side_.rows_;
    for (Eigen::Index m = 0; m <= side_.steps_; ++m) {
      const auto n = side_.grid_index(m);
      y.col(n)(rows) = inverse(m) * given.col(n)(rows);
    }
  }

  [[nodiscard]] std::size_t bytes() const override {
    return sizeof(double) * static_cast<std::size_t>(inverses_.size());
  }

 private:
  [[nodiscard]] Eigen::Map<const Matrix> inverse(Eigen::Index m) const {
    return jacobian_at_time(inverses_, m, std::ssize(side_.rows_));
  }

  const SteppedSide& side_;
  const Matrix& jacobians_;
  Matrix inverses_;
};

SteppedSide::SteppedSide(const Problem& problem, Side side, const WeightFamily& family, const Grid& grid,
                         const Options& options)
    : SideRule(problem, side), grid_(grid), steps_(grid.steps) {
  std::vector<WeightTable> own;
  for (Eigen::Index k = 0; k < differential_count_; ++k)
    own.push_back({&family, problem.component(rows_[static_cast<std::size_t>(k)]).order});
  const auto size = std::ssize(rows_);
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
void SteppedSide::for_each_own_time(Step step) const {
  if (empty()) return;
  const auto history = differential_count_ > 0 ? history_prototype_->copy() : nullptr;
  Vec sum = Vec::Zero(kappa_.rows()), f(kappa_.rows());
  double t = 0.0;
  for (Eigen::Index m = 0; m <= steps_; ++m) {
    if (m % steps_between_reports == 0) report_progress(0);
    if (m > 0 && history) {
      history->push(t, f.head(differential_count_));
      t = grid_.time(static_cast<int>(m));
      history->convolve(t, 0, sum.head(differential_count_));
    }
    step(m, sum, f);
  }
}

void SteppedSide::integrate(const Rows& f, Rows& value) const {
  for_each_own_time([&](Eigen::Index m, const Vec& sum, Vec& here) {
    const auto n = grid_index(m);
    here = f.col(n)(rows_);
    value.col(n)(rows_) = mass(m).cwiseProduct(value.col(n)(rows_)) + kappa(m).cwiseProduct(sum + here);
  });
}

std::unique_ptr<SideFactors> SteppedSide::factors(const Matrix& jacobians) const {
  return std::make_unique<Factors>(*this, jacobians);
}

Matrix SteppedSide::inverses(const Matrix& jacobians) const {
  const auto size = kappa_.rows();
  Matrix result(size * size, jacobians.cols() == 1 ? kappa_.cols() : steps_ + 1);
  const auto whole = static_cast<Eigen::Index>(std::lround(std::sqrt(static_cast<double>(jacobians.rows()))));
  for (Eigen::Index m = 0; m < result.cols(); ++m) {
    const Matrix own = jacobian_at_time(jacobians, grid_index(m), whole)(rows_, rows_);
    const Matrix system = Matrix(mass(m).asDiagonal()) - kappa(m).asDiagonal() * own;
    Eigen::Map<Matrix>(result.col(m).data(), size, size) = system.inverse();
  }
  return result;
}

std::shared_ptr<const Discretisation> discretisation_by_steps(const Problem& problem, const Grid& grid,
                                                              const Options& options,
                                                              const WeightFamily& family) {
  const auto side = [&](Side of) {
    return std::make_unique<SteppedSide>(problem, of, family, grid, options);
  };
  const Vec times =
      Vec::NullaryExpr(grid.steps + 1, [&](Eigen::Index n) { return grid.time(static_cast<int>(n)); });
  return std::make_shared<const Discretisation>(Discretisation{
      .left = times,
      .right = times.reverse(),
      .left_rule = side(Side::left),
      .right_rule = side(Side::right),
      .with_steps = [&problem, grid,
                     rule = Options{.history = options.history, .newton_tolerance = options.newton_tolerance},
                     &family](int steps) {
        return discretisation_by_steps(problem, {grid.end, steps, grid.grading}, rule, family);
      }});
}

}  // namespace fde
