#pragma once

#include "problem/problem.hpp"

namespace fde {

// The problem of u = y / unit. Its solves are the same computation in other numbers: where unit is no power
// of two every value, sum and weight times value is rounded otherwise, the initial values among them. What
// unit * u and y differ by is one sample of what rounding does to a result.
Problem in_units_of(double unit, const Problem& problem);

}  // namespace fde
