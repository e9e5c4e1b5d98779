// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// df/dy at (t, y), dense: the Jacobian that the problem gives, otherwise central differences with the
// increments 2^-18 max(1, |y_j|).
Matrix jacobian_at(const Problem& problem, double t, Vec y);

}  // namespace fde
