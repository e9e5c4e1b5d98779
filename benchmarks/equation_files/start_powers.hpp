#pragma once

#include "equation_files/equation_system.hpp"
#include "problem/smoothness.hpp"

namespace fde {

// The powers of t with which the solution starts, by the orders alone: a right-hand side that is smooth where
// the solution starts answers to t^p with sums of such p, and D^order u = t^q leads to t^(q + order) in u.
// Nothing is said of a system with an algebraic row, of one whose right-hand sides are not smooth there but
// for powers of t, and of orders so close to each other that there are more than 1e5 powers.
Smoothness start_powers(const EquationSystem& system, const Expressions& all);

}  // namespace fde
