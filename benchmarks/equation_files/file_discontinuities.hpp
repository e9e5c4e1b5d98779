// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The parameters in which the solution is not continuous at their present values: those that are the order q
// of a term, if q is an integer k below the leading order and u^(k)(0) is not 0. D^q u tends to u^(k) -
// u^(k)(0) from above and is u^(k) at k.
std::vector<Discontinuity> file_discontinuities(const EquationSystem& system, FileFormulas& formulas);

}  // namespace fde::bench
