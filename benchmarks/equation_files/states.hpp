// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::bench {

// The name, with _ behind it where the contents of the file have it.
std::string free_name(std::string name, const std::string& contents);

// How messages name the state of an unknown.
inline std::string state_meaning(const std::string& unknown) { return "the state of " + unknown; }

// The value of an expression without variables as a fraction; of a number that is none, such as sqrt(2), the
// shortest decimal that rounds to the same double.
reference::Rational nearest_fraction(Expression of, const ExpressionPool& pool);

}  // namespace fde::bench
