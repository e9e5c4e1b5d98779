// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The derivatives of the unknowns of algebraic rows by the other unknowns, -(df_a/dy_a)^-1 df_a/dy_d, in the
// places of both in the Jacobian df/dy. With them such an unknown is interpolated on a first step, where a
// polynomial does not follow the power of t with which it begins: what is interpolated is the unknown less
// its slopes times the others, whose fractional integrals are then added. 0 where constraints determine
// multipliers, whose df_a/dy_a is singular. Empty: there are no algebraic rows.
Matrix algebraic_slopes(const Problem& problem, const Matrix& jacobian);

}  // namespace fde
