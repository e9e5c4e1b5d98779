// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/decoupled_stage_matrix.hpp"

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
  solvable_ = factors_.factorise(*derivatives, weights.front());
}

void DecoupledStageMatrix::solve(Vec& b) const {
  if (solvable_) {
    factors_.solve(b);
  } else {
    b.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace fde
