// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/decoupled_stage_matrix.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <limits>

namespace fde {

void DecoupledStageMatrix::factorise(Run& /*run*/, double t, In y, In /*f*/, const StageWeights& weights) {
  const SparseMatrix* derivatives = &jacobian_;
  if (const auto* sparse = std::get_if<SparseJacobian>(&problem_.derivatives)) {
    jacobian_.resize(y.size(), y.size());
    sparse->at(t, y, jacobian_);
    jacobian_.makeCompressed();
  } else {
    derivatives = &std::get<SparseLinearPart>(problem_.derivatives).matrix;
  }
  using Square = Eigen::Matrix<double, stages, stages>;
  const Eigen::EigenSolver<Square> modes(Square(weights.front().transpose()));
  to_modes_ = modes.eigenvectors();
  from_modes_ = to_modes_.inverse();
  const auto& values = modes.eigenvalues();
  values.imag().cwiseAbs().minCoeff(&real_);
  values.imag().maxCoeff(&complex_);
  SparseMatrix matrix(y.size(), y.size());
  matrix.setIdentity();
  matrix -= values[real_].real() * *derivatives;
  matrix.makeCompressed();
  real_factors_ = sparse_factors(matrix);
  complex_factors_ = complex_factors(*derivatives, values[complex_]);
}

void DecoupledStageMatrix::solve(Vec& b) const {
  if (!real_factors_ || !complex_factors_) {
    b.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  auto values = b.reshaped(b.size() / stages, stages);
  Vec real = values * to_modes_.col(real_).real();
  real_factors_->solve(real);
  ComplexVec pair(real.size());
  pair.real() = values * to_modes_.col(complex_).real();
  pair.imag() = values * to_modes_.col(complex_).imag();
  complex_factors_->solve(pair);
  values = real * from_modes_.row(real_).real();
  values +=
      2.0 * (pair.real() * from_modes_.row(complex_).real() - pair.imag() * from_modes_.row(complex_).imag());
}

std::string_view DecoupledStageMatrix::solver() const {
  return complex_factors_ ? complex_factors_->name() : std::string_view();
}

}  // namespace fde
