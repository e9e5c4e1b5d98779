// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/growth_check.hpp"

#include <cmath>
#include <limits>

namespace fde {
namespace {

Vec gershgorin_bound_of(const DenseLinearPart& part) {
  const Vec diagonal = part.matrix.diagonal();
  return part.matrix.cwiseAbs().rowwise().sum() + diagonal - diagonal.cwiseAbs();
}

Vec gershgorin_bound_of(const SparseLinearPart& part) {
  const Vec diagonal = part.matrix.diagonal();
  return part.matrix.cwiseAbs() * Vec::Ones(part.matrix.cols()) + diagonal - diagonal.cwiseAbs();
}

}  // namespace

GrowthCheck::GrowthCheck(const Problem& problem)
    : orders_(orders_of(problem)), largest_accepted_kappa_(Vec::Zero(problem.size())) {
  const auto* dense = std::get_if<DenseLinearPart>(&problem.derivatives);
  gershgorin_bound_ = dense != nullptr ? gershgorin_bound_of(*dense)
                                       : gershgorin_bound_of(std::get<SparseLinearPart>(problem.derivatives));
  gershgorin_bound_(algebraic_rows(problem)).setConstant(std::numeric_limits<double>::infinity());
}

bool GrowthCheck::is_step_too_large(NewtonMatrix& matrix, const Vec& kappa, bool solvable) {
  // No larger than a step that was not too large.
  if ((kappa.array() <= largest_accepted_kappa_.array()).all()) return false;
  const int sign = solvable ? matrix.determinant_sign() : 0;
  Vec shorter = kappa;
  const double max_order = orders_.maxCoeff();
  bool too_large = false, moved = false;
  for (int halvings = 1; halvings <= 1024 && sign != 0 && !too_large && !is_diagonally_dominant(shorter);
       halvings *= 2) {
    for (Eigen::Index i = 0; i < shorter.size(); ++i)
      shorter[i] *= std::exp2(-halvings * orders_[i] / max_order);
    if ((shorter.array() <= largest_accepted_kappa_.array()).all()) {
      too_large = accepted_sign_ == -sign;
      break;
    }
    moved = true;
    const int before = matrix.factorise_linear(shorter) ? matrix.determinant_sign() : 0;
    if (before == 0) break;
    too_large = before == -sign;
  }
  if (moved) matrix.factorise_linear(kappa);
  if (!too_large) {
    largest_accepted_kappa_ = kappa;
    accepted_sign_ = sign;
  }
  return too_large;
}

bool GrowthCheck::is_diagonally_dominant(const Vec& kappa) const {
  return (kappa.array() * gershgorin_bound_.array() < 1.0).all();
}

}  // namespace fde
