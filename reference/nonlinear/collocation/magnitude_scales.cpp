// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/collocation/magnitude_scales.hpp"

#include <algorithm>

#include "fdebench/reference/nonlinear/march/rhs_at.hpp"

namespace fde::reference {

MagnitudeScales without_unbounded_scales(MagnitudeScales sizes, const Problem& problem) {
  if (std::ranges::none_of(problem.components, is_algebraic)) return sizes;
  sizes.rhs.setZero();
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    if (is_algebraic(problem.components[static_cast<std::size_t>(i)])) sizes.values[i] = 0.0;
  }
  return sizes;
}

MagnitudeScales sizes_at_start(const Problem& problem) {
  const Vec initial = taylor_part(problem, 0.0);
  return {initial.cwiseAbs(), rhs_at(problem, 0.0, initial).cwiseAbs(), largest_forcing(problem),
          Vec::Zero(problem.size())};
}

MagnitudeScales updated_scales(const MagnitudeScales& before, const Matrix& y, const Matrix& rhs,
                               const std::vector<Matrix>& jacobians) {
  MagnitudeScales sizes = before;
  for (Eigen::Index k = 0; k < rhs.rows(); ++k) {
    const Vec y_size = y.row(k).transpose().cwiseAbs();
    const Vec terms = jacobians[static_cast<std::size_t>(k)].cwiseAbs() * y_size;
    sizes.values = sizes.values.cwiseMax(y_size);
    sizes.rhs = sizes.rhs.cwiseMax(terms).cwiseMax(rhs.row(k).transpose().cwiseAbs());
  }
  return sizes;
}

}  // namespace fde::reference
