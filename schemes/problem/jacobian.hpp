#pragma once

#include "problem/problem.hpp"

namespace fde {

// df/dy at (t, y): what the problem declares, otherwise by central differences over 2^-18 max(1, |y_j|).
Matrix jacobian_at(const Problem& problem, double t, Vec y);

}  // namespace fde
