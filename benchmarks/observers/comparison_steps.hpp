// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// The steps at which a run of this many steps is compared with the reference: all if there are at most
// `most`, otherwise the first 16 and `most` evenly spaced ones.
constexpr int max_comparison_steps = 8192;
std::vector<int> comparison_steps(int steps, int most = max_comparison_steps);

// The number of steps at which a run of a scene with so many columns is compared: max_comparison_steps up to
// 32 columns, fewer of more, so that at most 2^18 values are compared, but at least 1024.
int comparison_steps_for(std::size_t columns);

// Their times.
std::vector<double> comparison_times(const Grid& grid, int most = max_comparison_steps);

// The times at which runs with an adaptive step size are compared with the reference, at steps or between
// them: `evenly` evenly spaced times, and four a decade towards the start and towards each jump, where
// solutions are powers of the time since then. At the start the smallest is that where t^order, with the
// smallest order, is rounding error.
constexpr int evenly_spaced_comparisons = 2048;
std::vector<double> comparison_times(const Problem& problem, int evenly = evenly_spaced_comparisons);

}  // namespace fde::bench
