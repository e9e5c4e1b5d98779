// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/starting_procedure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fdebench/schemes/solvers/dense_factors.hpp"
#include "fdebench/schemes/solvers/gmres.hpp"
#include "fdebench/schemes/solvers/sparse_lu.hpp"

namespace fde {
namespace {

constexpr double accuracy_of_gmres = 1e-3;
constexpr double refined_once = 1e-9;  // a second solve with this accuracy leaves an error below rounding

}  // namespace

StartingProcedure::StartingProcedure(const Problem& problem, const Grid& grid, StartingEquations equations,
                                     FirstOrder first_order)
    : problem_(problem),
      grid_(grid),
      size_(problem.size()),
      equations_(std::move(equations)),
      first_order_(std::move(first_order)) {}

Matrix StartingProcedure::solve(Run& run, double tolerance, SolveStatus& ending) const {
  Vec y = equations_.known.reshaped(), known = y;
  const Vec f = run.rhs(0.0, run.start());
  for (Eigen::Index n = 1; n <= steps(); ++n) step(known, n) += weights(n, 0).cwiseProduct(f);
  ending = take_first_order_steps(run, tolerance, y);
  if (ending != SolveStatus::finished) return {};
  const Vec guess = y;
  auto found = has_sylvester_form() ? iterate_decoupled(run, tolerance, known, y) : std::nullopt;
  if (!found) {
    y = guess;
    found = is_linear(problem_) ? solve_linear(run, known, y) : solve_by_newton(run, tolerance, known, y);
  }
  ending = *found;
  if (ending == SolveStatus::finished && !is_linear(problem_) && !is_near_guess(y, guess, run.start()))
    ending = SolveStatus::not_converged;
  return ending == SolveStatus::finished ? Matrix(y.reshaped(size_, steps())) : Matrix();
}

SolveStatus StartingProcedure::solve_by_newton(Run& run, double tolerance, const Vec& known, Vec& y) const {
  const Problem block = as_single_step_problem(y);
  Run once(block, {});
  const auto ending = NewtonSolver(block, tolerance).solve(once, {0.0, Vec::Ones(block.size()), known}, y);
  *run.cost().rhs_calls += steps() * *once.cost().rhs_calls;
  *run.cost().newton_iterations += steps() * *once.cost().newton_iterations;
  return ending;
}

std::optional<SolveStatus> StartingProcedure::iterate_decoupled(Run& run, double tolerance, const Vec& known,
                                                                Vec& y) const {
  constexpr double stagnation = 1e-10;  // smaller increments may have stopped shrinking because of rounding
  constexpr int most_iterations = 20, few_setbacks = 3;
  const Eigen::Index half = (steps() + 1) / 2;
  SparseMatrix buffer;
  const SparseMatrix& middle = sparse_jacobian_at(problem_, time(half), step(y, half), buffer);
  SylvesterFactors factors;
  const double accuracy = is_linear(problem_) ? refined_once : accuracy_of_gmres / 10.0;
  if (!factors.factorise(middle, weights_of_steps(), 1.0, accuracy)) return std::nullopt;
  double last = std::numeric_limits<double>::infinity();
  int setbacks = 0;
  for (int iteration = 1; iteration <= most_iterations && setbacks < few_setbacks; ++iteration) {
    Vec increment = residual(known, y);
    factors.solve(increment);
    if (!is_linear(problem_)) increment = with_all_jacobians(factors, y, increment);
    y += increment;
    *run.cost().rhs_calls += steps();
    *run.cost().newton_iterations += steps();
    if (is_linear(problem_) && iteration == 2) return SolveStatus::finished;
    const double now = increment.lpNorm<Eigen::Infinity>() / y.lpNorm<Eigen::Infinity>();
    if (now <= tolerance || (now <= stagnation && now > last / 2))
      return factors.determinant_sign() < 0 ? SolveStatus::step_too_large : SolveStatus::finished;
    if (!(now < last)) ++setbacks;
    last = now;
  }
  return std::nullopt;
}

Vec StartingProcedure::with_all_jacobians(const SylvesterFactors& factors, const Vec& y, const Vec& b) const {
  constexpr Eigen::Index most_values = 1 << 23;  // of all vectors that are stored
  const auto most_vectors = std::clamp<Eigen::Index>(most_values / b.size(), 6, 30);
  const Matrix coupling = weights_of_steps().transpose();
  Matrix f(size_, steps());
  SparseMatrix buffer;
  const auto apply = [&](const Vec& x) {
    for (Eigen::Index j = 1; j <= steps(); ++j)
      f.col(j - 1) = sparse_jacobian_at(problem_, time(j), step(y, j), buffer) * step(x, j);
    Vec rest = x;
    rest.reshaped(size_, steps()).noalias() -= f * coupling;
    factors.solve(rest);
    return rest;
  };
  return gmres(apply, b, accuracy_of_gmres, most_vectors);
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
  const auto path = first_order_({.end = time(count), .steps = count}, {.newton_tolerance = tolerance});
  *run.cost().rhs_calls += *path.cost.rhs_calls;
  if (is_linear(problem_)) return path.status;
  *run.cost().newton_iterations += *path.cost.newton_iterations;
  if (path.status == SolveStatus::finished) guess = path.y.rightCols(count).reshaped();
  return path.status;
}

bool StartingProcedure::has_sylvester_form() const {
  return equations_.weights.size() == 1 && has_sparse_jacobian(problem_);
}

SolveStatus StartingProcedure::solve_linear(Run& run, const Vec& known, Vec& y) const {
  const Vec rest = residual(known, y);
  *run.cost().rhs_calls += steps();
  *run.cost().newton_iterations += steps();
  if (has_sparse_jacobian(problem_)) {
    SparseMatrix matrix(y.size(), y.size()), identity(y.size(), y.size());
    differentiate_sparse(y, matrix);
    identity.setIdentity();
    matrix = identity - matrix;
    matrix.makeCompressed();
    const SparseLu factors(matrix);
    if (factors.info() != Eigen::Success) return SolveStatus::not_converged;
    y += factors.solve(rest);
  } else {
    Matrix matrix(y.size(), y.size());
    differentiate(y, matrix);
    y += (Matrix::Identity(y.size(), y.size()) - matrix).partialPivLu().solve(rest);
  }
  return y.allFinite() ? SolveStatus::finished : SolveStatus::not_converged;
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
    for (Eigen::Index n = 1; n <= steps(); ++n) step(f, n) += weights(n, j).cwiseProduct(of_step);
  }
}

Vec StartingProcedure::residual(const Vec& known, const Vec& y) const {
  Vec rest(y.size());
  evaluate(y, rest);
  rest += known - y;
  return rest;
}

void StartingProcedure::differentiate(In y, OutMatrix jacobian) const {
  Matrix of_step(size_, size_);
  for (Eigen::Index j = 1; j <= steps(); ++j) {
    evaluate_jacobian(problem_, time(j), step(y, j), of_step);
    for (Eigen::Index n = 1; n <= steps(); ++n)
      jacobian.block((n - 1) * size_, (j - 1) * size_, size_, size_) = weights(n, j).asDiagonal() * of_step;
  }
}

void StartingProcedure::differentiate_sparse(In y, SparseMatrix& jacobian) const {
  std::vector<Eigen::Triplet<double>> entries;
  SparseMatrix buffer;
  for (Eigen::Index j = 1; j <= steps(); ++j) {
    const SparseMatrix& of_step = sparse_jacobian_at(problem_, time(j), step(y, j), buffer);
    for (Eigen::Index column = 0; column < of_step.outerSize(); ++column) {
      for (SparseMatrix::InnerIterator entry(of_step, column); entry; ++entry) {
        for (Eigen::Index n = 1; n <= steps(); ++n) {
          entries.emplace_back((n - 1) * size_ + entry.row(), (j - 1) * size_ + entry.col(),
                               weights(n, j)[entry.row()] * entry.value());
        }
      }
    }
  }
  jacobian.resize(y.size(), y.size());
  jacobian.setFromTriplets(entries.begin(), entries.end());
}

}  // namespace fde
