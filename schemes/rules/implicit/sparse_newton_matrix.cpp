// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/sparse_newton_matrix.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace fde {

SparseNewtonMatrix::Pattern::Pattern(const SparseMatrix& matrix)
    : outer(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.cols() + 1),
      inner(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros()) {}

bool SparseNewtonMatrix::Pattern::matches(const SparseMatrix& matrix) const {
  return matrix.isCompressed() &&
         std::equal(outer.begin(), outer.end(), matrix.outerIndexPtr(),
                    matrix.outerIndexPtr() + matrix.cols() + 1) &&
         std::equal(inner.begin(), inner.end(), matrix.innerIndexPtr(),
                    matrix.innerIndexPtr() + matrix.nonZeros());
}

SparseNewtonMatrix::SparseNewtonMatrix(const Problem& problem)
    : problem_(problem),
      rows_(problem),
      identity_(problem.size(), problem.size()),
      derivatives_(problem.size(), problem.size()),
      matrix_(problem.size(), problem.size()) {
  identity_.setIdentity();
}

void SparseNewtonMatrix::linearise(Run& /*run*/, const StepEquations& step, In y, In /*f*/) {
  std::get<SparseJacobian>(problem_.derivatives).at(step.t, y, derivatives_);
  assemble(derivatives_, step.kappa);
}

bool SparseNewtonMatrix::factorise_linear(const Vec& kappa) {
  assemble(std::get<SparseLinearPart>(problem_.derivatives).matrix, kappa);
  factorise();
  return true;
}

int SparseNewtonMatrix::determinant_sign() { return factors_ ? factors_->determinant_sign() : 0; }

std::string_view SparseNewtonMatrix::solver() const {
  return factors_ ? factors_->active_method() : std::string_view();
}

void SparseNewtonMatrix::assemble(const SparseMatrix& derivatives, const Vec& kappa) {
  rows_.scale = kappa;
  if (assembled_pattern_.matches(derivatives)) {
    const auto* const rows = derivatives.innerIndexPtr();
    const auto* const starts = derivatives.outerIndexPtr();
    for (Eigen::Index j = 0; j < derivatives.outerSize(); ++j) {
      for (auto k = starts[j]; k < starts[j + 1]; ++k)
        matrix_.valuePtr()[k] = (rows[k] == j ? 1.0 : 0.0) - kappa[rows[k]] * derivatives.valuePtr()[k];
    }
    return;
  }
  matrix_ = identity_ - SparseMatrix(kappa.asDiagonal() * derivatives);
  matrix_.makeCompressed();
  assembled_pattern_ = Pattern();
  if (Pattern places(matrix_); places.matches(derivatives)) assembled_pattern_ = std::move(places);
}

void SparseNewtonMatrix::factorise() {
  const bool same_places = factors_ && analysed_pattern_.matches(matrix_);
  if (same_places && factors_->factorise(matrix_)) return;
  if (!same_places) analysed_pattern_ = Pattern(matrix_);
  factors_ = sparse_factors(matrix_);
}

void SparseNewtonMatrix::solve(Vec& b) const {
  if (factors_) {
    factors_->solve(b);
  } else {
    b.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
}

// The method is saved: it may be that of earlier matrices, where sparse_factors would choose another one for
// this matrix.
void SparseNewtonMatrix::state(Archive& archive) {
  const auto used = factors_ ? factors_->chosen_method() : std::string_view();
  std::vector<char> method(used.begin(), used.end());
  archive(rows_);
  archive.resizable(matrix_);
  archive.resizable(method);
  if (archive.is_reading()) {
    analysed_pattern_ = Pattern(matrix_);
    factors_ = method.empty() ? nullptr : sparse_factors(matrix_, {method.data(), method.size()});
  }
  if (factors_) archive(*factors_);
}

}  // namespace fde
