// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "fdebench/benchmarks/expressions/expressions.hpp"

namespace fde::bench {

// The expression as a formula that read_formula reads; `name`: the text of a variable. Common parts are
// repeated. Empty if the formula would be longer than max_formula_bytes.
std::string formula_text(const ExpressionPool& pool, Expression of,
                         const std::function<std::string(int variable)>& name);

}  // namespace fde::bench
