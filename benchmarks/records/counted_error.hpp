// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// An error of a run as it counts against an accuracy.
struct CountedError {
  double value;            // in the maximum norm at least the variation that one of its steps contains
  double reference_bound;  // of the reference with which it was measured, on the scale of the error

  // Whether the error is at most `accuracy`, whatever the reference hides.
  [[nodiscard]] bool is_within(double accuracy) const { return value + reference_bound <= accuracy; }
};

// nullopt if the run has no error of this kind. The record has the bound of the absolute error; on another
// scale it is that share of the error of this kind that it is of the absolute error.
std::optional<CountedError> counted_error(const Record& run, const ErrorKind& kind);

}  // namespace fde::bench
