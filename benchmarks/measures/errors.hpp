// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "fdebench/benchmarks/measures/measures.hpp"

namespace fde::bench {

// The error of each kind, then its constant-solution baseline of each kind, in the order of error_kinds; then
// the unresolved variation of each scale.
std::span<const Measure> error_measures();

}  // namespace fde::bench
