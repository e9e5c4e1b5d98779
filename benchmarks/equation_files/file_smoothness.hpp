// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {

// The powers of t with which the solution starts: those of [exact] where this gives sums of powers of t and
// the derivatives of the right-hand sides are finite at the start; for a linear system without chains, whose
// loads are powers of t, those of its series; else starting_powers(). With the components whose right-hand
// side jumps at a time.
Smoothness file_smoothness(const EquationSystem& system, const Problem& problem, FileFormulas& formulas);

// The parameters in which the solution is not continuous at their present values: those that are the order q
// of a term, if q is an integer k below the leading order and u^(k)(0) is not 0. D^q u tends to u^(k) -
// u^(k)(0) from above and is u^(k) at k.
std::vector<Discontinuity> file_discontinuities(const EquationSystem& system, FileFormulas& formulas);

}  // namespace fde::bench
