// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/expressions/instructions.hpp"

namespace fde::bench {

// A number as an operand of such a formula.
std::string formula_number(double value);

// The results as formulas of t and y1, y2, ..., in their order, as ProblemText has them. Common parts are
// repeated. Empty if they are together longer than a megabyte or contain a number that is not finite.
std::vector<std::string> texts_of(const InstructionList& list);

}  // namespace fde::bench
