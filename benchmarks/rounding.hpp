#pragma once

#include "problem.hpp"

namespace fde {

// The problem of u = y / unit. Its solves are the same computation in other numbers: where unit is no power
// of two every value, sum and weight times value is rounded otherwise, so what unit * u and y differ by is
// what rounding does to a result, up to a small factor.
Problem in_units_of(double unit, const Problem& problem);

}  // namespace fde
