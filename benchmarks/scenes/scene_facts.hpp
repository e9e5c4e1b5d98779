// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fde::bench {

// A parameter in which the solution is not continuous at its present value; `limit` says, in words, what a
// term of the equation tends to as the parameter tends to this value.
struct Discontinuity {
  std::string parameter, limit;

  bool operator==(const Discontinuity&) const = default;
};

// An equation for display only: two formulas, in which D(x, a) and J(x, a) are the left derivative and
// integral of order a, D_right and J_right the right ones, and sum(k, x) is a sum over k.
struct DisplayEquation {
  std::string left, right;

  bool operator==(const DisplayEquation&) const = default;
};

}  // namespace fde::bench
