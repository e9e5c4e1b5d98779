// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {

// The powers of t with which the solution starts: those of [exact] where this gives sums of powers of t and
// the derivatives of the right-hand sides are finite at the start; for a linear system without chains, whose
// loads are powers of t, those of its series; else starting_powers(). With the components whose right-hand
// side jumps at a time.
Smoothness file_smoothness(const EquationSystem& system, const Problem& problem, FileFormulas& formulas);

}  // namespace fde::bench
