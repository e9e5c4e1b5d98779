// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/dense_newton_matrix.hpp"

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

DenseNewtonMatrix::DenseNewtonMatrix(const Problem& problem)
    : problem_(problem), rows_(problem), matrix_(problem.size(), problem.size()), factors_(problem.size()) {}

void DenseNewtonMatrix::linearise(Run& run, const StepEquations& step, In y, In f) {
  if (!evaluate_jacobian(problem_, step.t, y, matrix_)) {
    const Vec sizes =
        step.known.cwiseAbs().cwiseMax(step.kappa.cwiseProduct(f).cwiseAbs()).cwiseProduct(rows_.mass);
    difference_jacobian_of_rhs(run, problem_, step.t, y, f, sizes, matrix_);
  }
  assemble(step.kappa);
}

bool DenseNewtonMatrix::factorise_linear(const Vec& kappa) {
  matrix_ = std::get<DenseLinearPart>(problem_.derivatives).matrix;
  assemble(kappa);
  factorise();
  return rows_.algebraic.empty() || !singular(matrix_);
}

void DenseNewtonMatrix::assemble(const Vec& kappa) {
  rows_.scale = kappa;
  for (const auto i : rows_.algebraic) rows_.scale[i] = 1.0 / matrix_.row(i).lpNorm<Eigen::Infinity>();
  for (Eigen::Index j = 0; j < matrix_.cols(); ++j) {
    for (Eigen::Index i = 0; i < matrix_.rows(); ++i) matrix_(i, j) *= -rows_.scale[i];
    matrix_(j, j) += rows_.mass[j];
  }
  for (const auto i : rows_.algebraic) rows_.weight[i] = matrix_.col(i).lpNorm<Eigen::Infinity>();
}

void DenseNewtonMatrix::state(Archive& archive) {
  archive(rows_, matrix_);
  if (archive.is_reading()) factorise();
}

}  // namespace fde
