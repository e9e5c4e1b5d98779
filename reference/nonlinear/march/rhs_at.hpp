// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

Vec rhs_at(const Problem& problem, double t, In y);

// y and the returned f have one row per time.
Matrix rhs_at(const Problem& problem, const Vec& times, const Matrix& y);

}  // namespace fde::reference
