// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// The increment of y_i over a step for f_i = 1: int_0^length (length - s)^(order-1) / Gamma(order) ds.
Vec unit_increment(const Problem& problem, double length);

}  // namespace fde::reference
