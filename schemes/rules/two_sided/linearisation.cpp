// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/linearisation.hpp"

#include <algorithm>

#include "fdebench/schemes/rules/implicit/difference_jacobian.hpp"

namespace fde {
void Linearisation::update(Run& run, const GridFunction& guess, const Residual& residual) {
  const auto& problem = equations_.problem();
  const auto size = problem.size();
  if (residual.conditions.size() > 0) differentiate_conditions(guess, residual.conditions);
  if (is_linear(problem) && jacobians_.size() > 0) return;
  jacobians_.resize(size * size, is_linear(problem) ? 1 : guess.y.cols());
  const Vec sizes = guess.y.cwiseAbs().rowwise().maxCoeff();
  for (Eigen::Index n = 0; n < jacobians_.cols(); ++n) {
    const double t = equations_.grid().time(static_cast<int>(n));
    Eigen::Map<Matrix> jacobian(jacobians_.col(n).data(), size, size);
    if (evaluate_jacobian(problem, t, guess.y.col(n), jacobian)) continue;
    difference_jacobian_of_rhs(run, problem, t, guess.y.col(n), residual.f.col(n), sizes, jacobian);
  }
  left_inverses_ = equations_.left().inverses(jacobians_);
  right_inverses_ = equations_.right().inverses(jacobians_);
}

void Linearisation::differentiate_conditions(const GridFunction& guess, const Vec& conditions) {
  const Vec start = guess.y.col(0), end = guess.y.rightCols<1>();
  const Vec sizes = guess.y.cwiseAbs().rowwise().maxCoeff();
  const auto& problem = equations_.problem();
  Vec result(conditions.size());
  by_start_.resize(conditions.size(), problem.size());
  by_end_.resize(conditions.size(), problem.size());
  const auto from_start = [&](const Vec& y) -> const Vec& {
    problem.conditions(y, end, result);
    return result;
  };
  const auto from_end = [&](const Vec& y) -> const Vec& {
    problem.conditions(start, y, result);
    return result;
  };
  const auto everywhere = [](const Vec&) { return true; };
  difference_jacobian(from_start, everywhere, start, conditions, sizes, by_start_);
  difference_jacobian(from_end, everywhere, end, conditions, sizes, by_end_);
}

Linearisation::LeftHandSides Linearisation::left_hand_sides(const GridFunction& x) const {
  Rows f(x.y.rows(), x.y.cols());
  for (Eigen::Index n = 0; n < f.cols(); ++n) f.col(n).noalias() = -jacobian(n) * x.y.col(n);
  Rows added = Rows::Zero(f.rows(), f.cols());
  equations_.add_unknown(x.unknown, added);
  Rows rows = x.y - added;
  equations_.left().integrate(f, rows);
  equations_.right().integrate(f, rows);
  return {std::move(rows), conditions(x.y)};
}

void Linearisation::forward_backward_sweep(const Rows& given, Rows& y) const {
  equations_.left().solve(given, jacobians_, left_inverses_, y);
  equations_.right().solve(given, jacobians_, right_inverses_, y);
}

Rows Linearisation::block_diagonal_solution(const Rows& given) const {
  Rows y(given.rows(), given.cols());
  equations_.left().solve_block_diagonal(given, left_inverses_, y);
  equations_.right().solve_block_diagonal(given, right_inverses_, y);
  return y;
}

Vec Linearisation::conditions(const Rows& y) const {
  if (equations_.unknown_count() == 0) return {};
  return by_start_ * y.col(0) + by_end_ * y.rightCols<1>();
}

Eigen::Map<const Matrix> Linearisation::jacobian(Eigen::Index n) const {
  const auto size = equations_.problem().size();
  return {jacobians_.col(std::min(n, jacobians_.cols() - 1)).data(), size, size};
}

std::size_t Linearisation::bytes() const {
  return sizeof(double) *
         static_cast<std::size_t>(jacobians_.size() + left_inverses_.size() + right_inverses_.size());
}

}  // namespace fde
