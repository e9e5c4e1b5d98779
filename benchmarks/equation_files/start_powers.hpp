// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {

// The powers of t with which the solution starts, derived from the orders: a right-hand side that is smooth
// at the initial values maps powers p to sums of such p, and D^order u = t^q gives t^(q + order) in u. Empty
// for a system with an algebraic row, for right-hand sides that are not smooth there apart from powers of t,
// and for orders that lead to more than 1e5 powers.
Smoothness starting_powers(const EquationSystem& system, const ExpressionPool& pool);

}  // namespace fde::bench
