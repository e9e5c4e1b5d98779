#pragma once

#include <functional>

#include "problem/problem.hpp"

namespace fde {

// x with apply(x) = b for a linear operator known by what it does, by the generalised minimal residual method
// (Saad & Schultz, SIAM J. Sci. Stat. Comput. 7, 1986) from 0, until the residual is below tolerance * |b| or
// after so many applications, at most; keeps a vector for each.
Vec gmres(const std::function<Vec(const Vec&)>& apply, const Vec& b, double tolerance, Eigen::Index most);

}  // namespace fde
