// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/rhs_at.hpp"

namespace fde::reference {

Vec rhs_at(const Problem& problem, double t, In y) {
  Vec f(problem.size());
  problem.rhs(t, y, f);
  return f;
}

Matrix rhs_at(const Problem& problem, const Vec& times, const Matrix& y) {
  Matrix rhs(times.size(), problem.size());
  for (Eigen::Index k = 0; k < times.size(); ++k) {
    rhs.row(k) = rhs_at(problem, times[k], y.row(k).transpose()).transpose();
  }
  return rhs;
}

}  // namespace fde::reference
