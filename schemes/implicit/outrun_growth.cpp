#include "implicit/outrun_growth.hpp"

#include <cmath>
#include <limits>

namespace fde {
namespace {

Vec reach_of(const DenseLinearPart& part) {
  const Vec diagonal = part.matrix.diagonal();
  return part.matrix.cwiseAbs().rowwise().sum() + diagonal - diagonal.cwiseAbs();
}

Vec reach_of(const SparseLinearPart& part) {
  const Vec diagonal = part.matrix.diagonal();
  return part.matrix.cwiseAbs() * Vec::Ones(part.matrix.cols()) + diagonal - diagonal.cwiseAbs();
}

}  // namespace

OutrunGrowth::OutrunGrowth(const Problem& problem)
    : orders_(problem.size()), cleared_(Vec::Zero(problem.size())) {
  const auto* dense = std::get_if<DenseLinearPart>(&problem.derivatives);
  reach_ = dense != nullptr ? reach_of(*dense) : reach_of(std::get<SparseLinearPart>(problem.derivatives));
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const Component& component = problem.components[static_cast<std::size_t>(i)];
    orders_[i] = component.order;
    if (algebraic(component)) reach_[i] = std::numeric_limits<double>::infinity();
  }
}

bool OutrunGrowth::outruns(NewtonMatrix& matrix, const Vec& kappa, bool solvable) {
  // No larger than a step that was not too large.
  if ((kappa.array() <= cleared_.array()).all()) return false;
  const int sign = solvable ? matrix.determinant_sign() : 0;
  Vec shorter = kappa;
  const double largest_order = orders_.maxCoeff();
  bool outrun = false, moved = false;
  for (int halvings = 1; halvings <= 1024 && sign != 0 && !outrun && !dominated(shorter); halvings *= 2) {
    for (Eigen::Index i = 0; i < shorter.size(); ++i)
      shorter[i] *= std::exp2(-halvings * orders_[i] / largest_order);
    if ((shorter.array() <= cleared_.array()).all()) {
      outrun = sign_there_ == -sign;
      break;
    }
    moved = true;
    const int before = matrix.factorise_linear(shorter) ? matrix.determinant_sign() : 0;
    if (before == 0) break;
    outrun = before == -sign;
  }
  if (moved) matrix.factorise_linear(kappa);
  if (!outrun) {
    cleared_ = kappa;
    sign_there_ = sign;
  }
  return outrun;
}

bool OutrunGrowth::dominated(const Vec& kappa) const { return (kappa.array() * reach_.array() < 1.0).all(); }

}  // namespace fde
