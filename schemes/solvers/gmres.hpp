// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// Solves apply(x) = b for a linear operator by the generalised minimal residual method (Saad & Schultz, SIAM
// J. Sci. Stat. Comput. 7, 1986) from 0, until the residual is below tolerance * |b|, with at most `most`
// applications; stores one vector for each. First with at most 16 applications and vectors; if these do not
// suffice, anew.
Vec gmres(const std::function<Vec(const Vec&)>& apply, const Vec& b, double tolerance, Eigen::Index most);

// The largest number of vectors of this length stored for one solution: a quarter of a gigabyte, but 20 to
// 200, and at most `length`.
Eigen::Index max_krylov_vectors(Eigen::Index length);

// The tolerance of GMRES for Newton's linear equations at all times at once.
constexpr double linear_tolerance = 1e-10;

}  // namespace fde
