// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {

// The powers of t with which the solution starts, derived from the orders. A right-hand side that is linear
// in D^a u with a constant coefficient maps a power p of u to p - a, one that is smooth at the initial values
// maps powers to their sums, and D^order u = t^q gives t^(q + order) in u. Powers below first_powers() are
// left out. Empty for right-hand sides that are not smooth there apart from powers of t, and for orders that
// lead to more than 1e5 powers. Precondition: there are no algebraic rows.
Smoothness starting_powers(const EquationSystem& system, ExpressionPool& pool);

// Appends the powers of the rows of a chain, from those of its unknown in increasing order.
void add_powers(const Chain& chain, const std::vector<double>& powers, Smoothness& smoothness);

}  // namespace fde::bench
