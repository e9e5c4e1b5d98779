// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>

#include "fdebench/benchmarks/expressions/instructions.hpp"

namespace fde::bench {

// Evaluates the instructions of a list. Precondition: y and results do not overlap.
using MachineFunction = void(double t, const double* y, double* results);

// Machine code with the same results as `interpret`, to the last bit; of a NaN the sign and payload may
// differ. nullptr where there is none: on processors other than x86-64, where the system denies executable
// memory, for mittag_leffler, which may throw, and for more than most_compiled_instructions.
std::shared_ptr<MachineFunction> machine_code(const InstructionList& list);

inline constexpr std::size_t most_compiled_instructions = 20'000;

}  // namespace fde::bench
