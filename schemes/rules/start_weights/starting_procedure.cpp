// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/starting_procedure.hpp"

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace fde {

StartingProcedure::StartingProcedure(const Problem& problem, const Grid& grid, StartingEquations equations,
                                     FirstOrder first_order)
    : problem_(problem),
      grid_(grid),
      size_(problem.size()),
      equations_(std::move(equations)),
      first_order_(std::move(first_order)) {}

Matrix StartingProcedure::solve(Run& run, double tolerance, SolveStatus& ending) const {
  Vec guess = equations_.known.reshaped(), known = guess;
  const Vec f = run.rhs(0.0, run.start());
  for (Eigen::Index n = 1; n <= steps(); ++n) step(known, n) += of(n).col(0).cwiseProduct(f);
  ending = take_first_order_steps(run, tolerance, guess);
  if (ending != SolveStatus::finished) return {};
  const Problem block = as_single_step_problem(guess);
  Vec y = guess;
  if (is_linear(problem_)) {
    ending = solve_linear(known, y) ? SolveStatus::finished : SolveStatus::not_converged;
    *run.cost().rhs_calls += steps();
    *run.cost().newton_iterations += steps();
  } else {
    Run once(block, {});
    ending = NewtonSolver(block, tolerance).solve(once, {0.0, Vec::Ones(block.size()), known}, y);
    *run.cost().rhs_calls += steps() * *once.cost().rhs_calls;
    *run.cost().newton_iterations += steps() * *once.cost().newton_iterations;
    if (ending == SolveStatus::finished && !is_near_guess(y, guess, run.start()))
      ending = SolveStatus::not_converged;
  }
  return ending == SolveStatus::finished ? Matrix(y.reshaped(size_, steps())) : Matrix();
}

bool StartingProcedure::is_near_guess(In y, In guess, In start) const {
  constexpr double rounding = 1e-12;
  double largest_apart = 0.0, largest_moved = rounding;
  for (Eigen::Index i = 0; i < size_; ++i) {
    double moved = 0.0, apart = 0.0;
    for (Eigen::Index at = i; at < y.size(); at += size_) {
      moved = std::max(moved, std::abs(guess[at] - start[i]));
      apart = std::max(apart, std::abs(y[at] - guess[at]));
    }
    const double size = std::max({moved, apart, std::abs(start[i])});
    if (size == 0.0) continue;
    largest_apart = std::max(largest_apart, apart / size);
    largest_moved = std::max(largest_moved, moved / size);
  }
  return largest_apart <= largest_moved;
}

SolveStatus StartingProcedure::take_first_order_steps(Run& run, double tolerance, Vec& guess) const {
  const auto count = static_cast<int>(is_linear(problem_) ? 1 : steps());
  const auto path = first_order_({.end = time(count), .steps = count}, {.tolerance = tolerance});
  *run.cost().rhs_calls += *path.cost.rhs_calls;
  if (is_linear(problem_)) return path.status;
  *run.cost().newton_iterations += *path.cost.newton_iterations;
  if (path.status == SolveStatus::finished) guess = path.y.rightCols(count).reshaped();
  return path.status;
}

bool StartingProcedure::solve_linear(const Vec& known, Vec& y) const {
  Vec rest(y.size());
  evaluate(y, rest);
  rest += known - y;
  if (has_sparse_jacobian(problem_)) {
    SparseMatrix matrix(y.size(), y.size()), identity(y.size(), y.size());
    differentiate_sparse(y, matrix);
    identity.setIdentity();
    matrix = identity - matrix;
    matrix.makeCompressed();
    const Eigen::SparseLU<SparseMatrix> factors(matrix);
    if (factors.info() != Eigen::Success) return false;
    y += factors.solve(rest);
  } else {
    Matrix matrix(y.size(), y.size());
    differentiate(y, matrix);
    y += (Matrix::Identity(y.size(), y.size()) - matrix).partialPivLu().solve(rest);
  }
  return y.allFinite();
}

Problem StartingProcedure::as_single_step_problem(const Vec& guess) const {
  Problem block;
  for (Eigen::Index n = 1; n <= steps(); ++n) {
    for (Eigen::Index i = 0; i < size_; ++i) block.components.push_back({1.0, {guess[(n - 1) * size_ + i]}});
  }
  block.rhs = [this](double, In y, Out f) { evaluate(y, f); };
  if (has_sparse_jacobian(problem_)) {
    block.derivatives =
        SparseJacobian{[this](double, In y, SparseMatrix& jacobian) { differentiate_sparse(y, jacobian); }};
  } else if (has_jacobian(problem_)) {
    block.derivatives =
        DenseJacobian{[this](double, In y, OutMatrix jacobian) { differentiate(y, jacobian); }};
  }
  return block;
}

void StartingProcedure::evaluate(In y, Out f) const {
  Vec of_step(size_);
  f.setZero();
  for (Eigen::Index j = 1; j <= steps(); ++j) {
    problem_.rhs(time(j), step(y, j), of_step);
    for (Eigen::Index n = 1; n <= steps(); ++n) step(f, n) += of(n).col(j).cwiseProduct(of_step);
  }
}

void StartingProcedure::differentiate(In y, OutMatrix jacobian) const {
  Matrix of_step(size_, size_);
  for (Eigen::Index j = 1; j <= steps(); ++j) {
    evaluate_jacobian(problem_, time(j), step(y, j), of_step);
    for (Eigen::Index n = 1; n <= steps(); ++n)
      jacobian.block((n - 1) * size_, (j - 1) * size_, size_, size_) = of(n).col(j).asDiagonal() * of_step;
  }
}

void StartingProcedure::differentiate_sparse(In y, SparseMatrix& jacobian) const {
  std::vector<Eigen::Triplet<double>> entries;
  SparseMatrix of_step(size_, size_);
  for (Eigen::Index j = 1; j <= steps(); ++j) {
    if (const auto* part = std::get_if<SparseLinearPart>(&problem_.derivatives)) {
      of_step = part->matrix;
    } else {
      std::get<SparseJacobian>(problem_.derivatives).at(time(j), step(y, j), of_step);
    }
    for (Eigen::Index column = 0; column < of_step.outerSize(); ++column) {
      for (SparseMatrix::InnerIterator entry(of_step, column); entry; ++entry) {
        for (Eigen::Index n = 1; n <= steps(); ++n) {
          entries.emplace_back((n - 1) * size_ + entry.row(), (j - 1) * size_ + entry.col(),
                               of(n)(entry.row(), j) * entry.value());
        }
      }
    }
  }
  jacobian.resize(y.size(), y.size());
  jacobian.setFromTriplets(entries.begin(), entries.end());
}

}  // namespace fde
