#pragma once

#include <functional>

#include "problem/problem.hpp"

namespace fde {

// x with apply(x) = b for a linear operator known by what it does, by the generalised minimal residual method
// (Saad & Schultz, SIAM J. Sci. Stat. Comput. 7, 1986) from 0, until the residual is below tolerance * |b| or
// after so many applications, at most; keeps a vector for each.
Vec gmres(const std::function<Vec(const Vec&)>& apply, const Vec& b, double tolerance, Eigen::Index most);

// How many vectors of this length may be kept for one solution: a quarter of a gigabyte, but 20 to 200.
Eigen::Index most_vectors(Eigen::Index length);

// What Newton's linear equations of all times at once are solved to.
constexpr double linear_tolerance = 1e-10;

}  // namespace fde
