// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/reference.hpp"

namespace fde::reference {

// The y with y(0) = 0, y(1) = 1 for which 1/2 int_0^1 (D^alpha y)^2 dt is least (Agrawal, J. Math. Anal.
// Appl. 272, 2002), D^alpha the left Caputo derivative from 0:
//   y = (2 alpha - 1) int_0^t ((t - s)(1 - s))^(alpha-1) ds,
//   D^alpha y = (2 alpha - 1) Gamma(alpha) (1 - t)^(alpha-1),
// infinite at t = 1 for alpha < 1. The least value is (2 alpha - 1) Gamma(alpha)^2 / 2. Components: y,
// D^alpha y. Throws std::invalid_argument for alpha outside (1/2, 1]; the functions of the reference do for
// times outside [0, 1] and for digits < 1.
Reference extremum_reference(double alpha);

}  // namespace fde::reference
