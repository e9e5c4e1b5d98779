#pragma once

#include "problem/resolution.hpp"
#include "stepping/run.hpp"

namespace fde {

// The length on which a first step by the rectangle rule is as accurate as asked, from 1e-290 of the end on.
double first_length(const Problem& problem, const Accuracy& accuracy, Run& run);

// Whether there are rows from 0, and a first step of this part of the end is so short that none of them is
// asked for digits.
bool asks_less(const Problem& problem, In start, double part_of_end);

}  // namespace fde
