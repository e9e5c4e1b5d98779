// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/dense_newton_matrix.hpp"

#include <cmath>

#include "fdebench/schemes/problem/vectors.hpp"
#include "fdebench/schemes/rules/implicit/difference_jacobian.hpp"

namespace fde {
namespace {

// Whether `a` is singular up to rounding, after its rows and columns are scaled to equal size.
bool singular(Matrix a) {
  constexpr double rounding = 1e-14;
  const Vec rows = a.rowwise().lpNorm<Eigen::Infinity>();
  a.array().colwise() /= rows.array();
  const Eigen::RowVectorXd columns = a.colwise().lpNorm<Eigen::Infinity>();
  a.array().rowwise() /= columns.array();
  Eigen::FullPivLU<Matrix> factors(a);
  factors.setThreshold(rounding);
  return !factors.isInvertible();
}

}  // namespace

template <int size>
DenseNewtonMatrix<size>::DenseNewtonMatrix(const Problem& problem)
    : problem_(problem), rows_(problem), matrix_(problem.size(), problem.size()) {}

template <int size>
void DenseNewtonMatrix<size>::linearise(Run& run, const StepEquations& step, In y, In f) {
  if (!evaluate_jacobian(problem_, step.t, y, matrix_)) {
    const Vec sizes =
        step.known.cwiseAbs().cwiseMax(step.kappa.cwiseProduct(f).cwiseAbs()).cwiseProduct(rows_.mass);
    difference_jacobian_of_rhs(run, problem_, step.t, y, f, sizes, matrix_);
  }
  assemble(step.kappa);
}

template <int size>
bool DenseNewtonMatrix<size>::factorise_linear(const Vec& kappa) {
  matrix_ = std::get<DenseLinearPart>(problem_.derivatives).matrix;
  assemble(kappa);
  factorise();
  return rows_.algebraic.empty() || !singular(matrix_);
}

template <int size>
int DenseNewtonMatrix<size>::determinant_sign() {
  const double signs = factors_.matrixLU().diagonal().array().sign().prod();
  if (signs == 0.0 || std::isnan(signs)) return 0;
  // g++ 12 warns of Eigen's loop over a single row.
  const bool even = size == 1 || factors_.permutationP().determinant() > 0;
  return (signs > 0.0) == even ? 1 : -1;
}

template <int size>
void DenseNewtonMatrix<size>::assemble(const Vec& kappa) {
  rows_.scale = kappa;
  for (const auto i : rows_.algebraic)
    rows_.scale[i] = 1.0 / matrix_.row(i).template lpNorm<Eigen::Infinity>();
  for (Eigen::Index j = 0; j < matrix_.cols(); ++j) {
    for (Eigen::Index i = 0; i < matrix_.rows(); ++i) matrix_(i, j) *= -rows_.scale[i];
    matrix_(j, j) += rows_.mass[j];
  }
  for (const auto i : rows_.algebraic) rows_.weight[i] = matrix_.col(i).template lpNorm<Eigen::Infinity>();
}

template <int size>
void DenseNewtonMatrix<size>::solve(Vec& b) const {
  Eigen::Map<Eigen::Matrix<double, size, 1>> x(b.data(), b.size());
  Eigen::Matrix<double, size, 1> right(b.size());
  for_each_component(b.size(), [&](Eigen::Index i) { right[i] = b[i]; });
  x = factors_.solve(right);
}

template <int size>
void DenseNewtonMatrix<size>::state(Archive& archive) {
  archive(rows_, matrix_);
  if (archive.is_reading()) factorise();
}

namespace {

template <int size = 1>
std::unique_ptr<NewtonMatrix> make(const Problem& problem) {
  constexpr int largest = 8;
  if constexpr (size > largest) {
    return std::make_unique<DenseNewtonMatrix<Eigen::Dynamic>>(problem);
  } else {
    if (problem.size() == size) return std::make_unique<DenseNewtonMatrix<size>>(problem);
    return make<size + 1>(problem);
  }
}

}  // namespace

std::unique_ptr<NewtonMatrix> make_dense_newton_matrix(const Problem& problem) { return make(problem); }

}  // namespace fde
