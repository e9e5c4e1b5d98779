// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// The size with which a first step by the rectangle rule meets the tolerance; at least 1e-290 of the end.
double initial_step_size(const Problem& problem, const Tolerance& accuracy, Run& run);

// Whether there are components that start from 0 and, on a first step of this part of the end, none of them
// has to meet the relative tolerance.
bool exempt_from_relative_tolerance(const Problem& problem, In start, double part_of_end);

}  // namespace fde
