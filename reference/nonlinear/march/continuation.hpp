// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// Where f depends on y so strongly that y changes much within a step, the equations y = history + W f(y) of
// the step may have several roots. The one that continues the solution is followed while W grows: part W,
// with a part so small at first that y hardly changes, which is doubled up to 1.

// The first part: 1 where y hardly changes with all of W. weights: W_i of each component; jacobian: df/dy at
// the start of the step.
double first_part(const Problem& problem, const std::vector<Matrix>& weights, const Matrix& jacobian);

// part W_i; those of algebraic rows are kept.
std::vector<Matrix> reduced(const Problem& problem, std::vector<Matrix> weights, double part);

}  // namespace fde::reference
