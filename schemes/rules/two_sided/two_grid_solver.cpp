// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/two_grid_solver.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/solvers/gmres.hpp"

namespace fde {

namespace {

// Packs rows and conditions into one vector and unpacks them; a condition has the weight of a row at all
// times.
struct Packing {
  Eigen::Index rows, times, conditions;

  [[nodiscard]] double scale() const { return std::sqrt(static_cast<double>(times)); }
  [[nodiscard]] Vec packed(const Rows& y, In numbers) const {
    Vec all(rows * times + conditions);
    all << y.reshaped(), scale() * numbers;
    return all;
  }
  [[nodiscard]] Linearisation::LeftHandSides unpacked(const Vec& all) const {
    return {all.head(rows * times).reshaped(rows, times), all.tail(conditions) / scale()};
  }
};

}  // namespace

DenseLinearisation::DenseLinearisation(const GlobalEquations& equations)
    : rows_(equations.problem().size()),
      times_(equations.times()),
      weights_(static_cast<std::size_t>(rows_), Matrix(times_, times_)),
      unknown_columns_(size(), equations.unknown_count()) {
  const auto integrated = [&](const Rows& f, Rows value) {
    equations.left().integrate(f, value);
    equations.right().integrate(f, value);
    return value;
  };
  const Rows none = Rows::Zero(rows_, times_);
  mass_ = integrated(none, Rows::Ones(rows_, times_));
  for (Eigen::Index n = 0; n < times_; ++n) {
    Rows f = none;
    f.col(n).setOnes();
    const Rows column = integrated(f, none);
    for (Eigen::Index i = 0; i < rows_; ++i)
      weights_[static_cast<std::size_t>(i)].col(n) = column.row(i).transpose();
  }
  for (Eigen::Index k = 0; k < equations.unknown_count(); ++k) {
    Rows added = none;
    equations.add_unknown(Vec::Unit(equations.unknown_count(), k), added);
    unknown_columns_.col(k) = -mass_.cwiseProduct(added).reshaped();
  }
}

void DenseLinearisation::factorise(const Linearisation& linearisation) {
  const auto unknown = unknown_columns_.cols();
  Matrix all = Matrix::Zero(size() + unknown, size() + unknown);
  for (Eigen::Index n = 0; n < times_; ++n) {
    const auto jacobian = linearisation.jacobian(n);
    for (Eigen::Index i = 0; i < rows_; ++i) {
      const auto& weights = weights_[static_cast<std::size_t>(i)];
      for (Eigen::Index j = 0; j < rows_; ++j) {
        if (jacobian(i, j) == 0.0) continue;
        all.col(n * rows_ + j)(Eigen::seqN(i, times_, rows_)) -= jacobian(i, j) * weights.col(n);
      }
    }
  }
  all.diagonal().head(size()) += mass_.reshaped();
  all.topRightCorner(size(), unknown) = unknown_columns_;
  if (unknown > 0) {
    all.bottomRows(unknown).leftCols(rows_) += linearisation.conditions_by_start();
    all.bottomRows(unknown).middleCols(size() - rows_, rows_) += linearisation.conditions_by_end();
  }
  factors_.compute(all);
}

GridFunction DenseLinearisation::solution(const Linearisation::LeftHandSides& right) const {
  Vec all(size() + right.conditions.size());
  all << right.rows.reshaped(), right.conditions;
  const Vec x = factors_.solve(all);
  return {.y = x.head(size()).reshaped(rows_, times_), .unknown = x.tail(right.conditions.size())};
}

TwoGridSolver::TwoGridSolver(const GlobalEquations& equations, int coarse_steps)
    : equations_(equations),
      coarse_equations_(
          equations.with_steps(std::min(coarse_steps, static_cast<int>(equations.times()) - 1))),
      coarse_(coarse_equations_),
      dense_(coarse_equations_) {}

void TwoGridSolver::update(Run& run, const GridFunction& guess) {
  const GridFunction here{.y = interpolate_linearly(times(), guess.y, coarse_times()),
                          .unknown = guess.unknown};
  coarse_.update(run, here, coarse_equations_.residual(run, here));
  dense_.factorise(coarse_);
}

GridFunction TwoGridSolver::preconditioned(const Linearisation& fine,
                                           const Linearisation::LeftHandSides& right) const {
  GridFunction x{.y = fine.block_diagonal_solution(right.rows),
                 .unknown = Vec::Zero(right.conditions.size())};
  const auto done = fine.left_hand_sides(x);
  const auto correction =
      dense_.solution({interpolate_linearly(times(), right.rows - done.rows, coarse_times()),
                       right.conditions - done.conditions});
  x.y += interpolate_linearly(coarse_times(), correction.y, times());
  x.unknown += correction.unknown;
  return x;
}

GridFunction TwoGridSolver::solution(const Linearisation& fine, const Residual& residual) const {
  const Packing packing{residual.rows.rows(), residual.rows.cols(), residual.conditions.size()};
  const Vec b = packing.packed(residual.rows, -residual.conditions);
  const auto apply = [&](const Vec& z) -> Vec {
    const auto sides = fine.left_hand_sides(preconditioned(fine, packing.unpacked(z)));
    return packing.packed(sides.rows, sides.conditions);
  };
  return preconditioned(fine,
                        packing.unpacked(gmres(apply, b, linear_tolerance, max_krylov_vectors(b.size()))));
}

std::size_t TwoGridSolver::bytes() const {
  const auto fine = equations_.problem().size() * equations_.times() + equations_.unknown_count();
  const auto coarse = equations_.problem().size() * coarse_equations_.times() + equations_.unknown_count();
  return coarse_.bytes() +
         sizeof(double) * static_cast<std::size_t>(fine * max_krylov_vectors(fine) + coarse * coarse);
}

Rows interpolate_linearly(const Vec& from, const Rows& y, const Vec& to) {
  if (from.size() == to.size() && from == to) return y;
  Rows result(y.rows(), to.size());
  Eigen::Index after = 1;
  for (Eigen::Index n = 0; n < to.size(); ++n) {
    while (after < from.size() - 1 && from[after] < to[n]) ++after;
    const double share = (to[n] - from[after - 1]) / (from[after] - from[after - 1]);
    result.col(n) = (1.0 - share) * y.col(after - 1) + share * y.col(after);
  }
  return result;
}

}  // namespace fde
