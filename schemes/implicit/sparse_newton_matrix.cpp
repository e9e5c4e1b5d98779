#include "implicit/sparse_newton_matrix.hpp"

#include <algorithm>
#include <limits>

namespace fde {
namespace {

bool same_pattern(const SparseMatrix& a, const SparseMatrix& b) {
  return a.nonZeros() == b.nonZeros() && a.cols() == b.cols() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

}  // namespace

SparseNewtonMatrix::SparseNewtonMatrix(const Problem& problem)
    : problem_(problem),
      rows_(problem),
      identity_(problem.size(), problem.size()),
      derivatives_(problem.size(), problem.size()) {
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

int SparseNewtonMatrix::determinant_sign() {
  return factors_.info() == Eigen::Success ? static_cast<int>(factors_.signDeterminant()) : 0;
}

void SparseNewtonMatrix::assemble(const SparseMatrix& derivatives, const Vec& kappa) {
  rows_.scale = kappa;
  matrix_ = identity_ - SparseMatrix(kappa.asDiagonal() * derivatives);
  matrix_.makeCompressed();
}

void SparseNewtonMatrix::factorise() {
  if (!same_pattern(matrix_, analysed_)) {
    factors_.analyzePattern(matrix_);
    analysed_ = matrix_;
  }
  factors_.factorize(matrix_);
}

void SparseNewtonMatrix::solve(Vec& b) const {
  if (factors_.info() == Eigen::Success) {
    b = factors_.solve(b).eval();
  } else {
    b.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace fde
