// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/solvers/five_point_matrix.hpp"

namespace fde::bench {

// The matrix of 1 - strength (d/dx a d/dx + d/dy a d/dy - r) by second differences on n x m interior points
// of the unit square, with a diffusivity a(x, y) and a reaction r(x, y).
template <class Diffusivity, class Reaction>
SparseMatrix step_matrix(Eigen::Index n, Eigen::Index m, double strength, Diffusivity a, Reaction r) {
  const Eigen::Index size = n * m;
  FivePointMatrix matrix{n, m, Vec(size), Vec::Zero(size), Vec::Zero(size)};
  const double dx = 1.0 / static_cast<double>(n + 1), dy = 1.0 / static_cast<double>(m + 1);
  const double cx = strength / (dx * dx), cy = strength / (dy * dy);
  for (Eigen::Index j = 0; j < m; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const double x = dx * static_cast<double>(i + 1), y = dy * static_cast<double>(j + 1);
      const double right = cx * a(x + dx / 2.0, y), above = cy * a(x, y + dy / 2.0);
      const double sides = right + above + cx * a(x - dx / 2.0, y) + cy * a(x, y - dy / 2.0);
      const Eigen::Index place = i + n * j;
      matrix.diagonal[place] = 1.0 + sides + strength * r(x, y);
      if (i + 1 < n) matrix.line_coupling[place] = -right;
      if (j + 1 < m) matrix.cross_coupling[place] = -above;
    }
  }
  return to_sparse(matrix);
}

// The same matrix with a = 1 and r = 0.
inline SparseMatrix step_matrix(Eigen::Index n, Eigen::Index m, double strength) {
  const auto one = [](double, double) { return 1.0; };
  const auto none = [](double, double) { return 0.0; };
  return step_matrix(n, m, strength, one, none);
}

}  // namespace fde::bench
