#pragma once

#include "problem/resolution.hpp"
#include "stepping/run.hpp"

namespace fde {

// The size with which a first step by the rectangle rule meets the tolerance; at least 1e-290 of the end.
double first_length(const Problem& problem, const Accuracy& accuracy, Run& run);

// Whether there are components that start from 0 and, on a first step of this part of the end, none of them
// has to meet the relative tolerance.
bool asks_less(const Problem& problem, In start, double part_of_end);

}  // namespace fde
