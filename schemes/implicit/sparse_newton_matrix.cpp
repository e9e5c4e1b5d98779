#include "implicit/sparse_newton_matrix.hpp"

#include <limits>
#include <utility>

namespace fde {

SparseNewtonMatrix::Pattern::Pattern(const SparseMatrix& matrix)
    : outer(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.cols() + 1),
      inner(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros()) {}

SparseNewtonMatrix::SparseNewtonMatrix(const Problem& problem)
    : problem_(problem),
      rows_(problem),
      identity_(problem.size(), problem.size()),
      derivatives_(problem.size(), problem.size()),
      matrix_(problem.size(), problem.size()),
      analysed_(derivatives_) {
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
  return factors_ ? factors_->name() : std::string_view();
}

void SparseNewtonMatrix::assemble(const SparseMatrix& derivatives, const Vec& kappa) {
  rows_.scale = kappa;
  matrix_ = identity_ - SparseMatrix(kappa.asDiagonal() * derivatives);
  matrix_.makeCompressed();
}

void SparseNewtonMatrix::factorise() {
  Pattern pattern(matrix_);
  if (factors_ && pattern == analysed_ && factors_->factorise(matrix_)) return;
  analysed_ = std::move(pattern);
  factors_ = sparse_factors(matrix_);
}

void SparseNewtonMatrix::solve(Vec& b) const {
  if (factors_) {
    factors_->solve(b);
  } else {
    b.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
}

// A matrix may be factorised by the method that served those before it, where another would be taken for it
// alone.
void SparseNewtonMatrix::state(Archive& archive) {
  const auto name = solver();
  std::vector<char> method(name.begin(), name.end());
  archive(rows_);
  archive.grown(matrix_);
  archive.grown(method);
  if (!archive.reads()) return;
  analysed_ = Pattern(matrix_);
  factors_ = method.empty() ? nullptr : sparse_factors(matrix_, {method.data(), method.size()});
}

}  // namespace fde
