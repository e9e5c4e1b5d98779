// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/reference.hpp"

namespace fde::reference {

// One term coefficient * t^(power + multiple * order), the exponent computed at the requested precision.
struct PowerTerm {
  double coefficient, power, multiple = 0.0;
};

// The sum of the terms, in double and in digits: the solution of a manufactured problem.
Reference power_sum(const std::vector<PowerTerm>& terms, double order = 0.0);

}  // namespace fde::reference
