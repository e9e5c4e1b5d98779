// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/measures/judge.hpp"
#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// The rows of an examination, one a measure and the ending last; and the rows of the times of repeated
// solves. `run` is a row without quantity and value.
std::vector<Record> rows_of_examination(const Record& run, const Assessment& judgement);
std::vector<Record> rows_of_times(const Record& run, const TimedSolves& timed);

}  // namespace fde::bench
