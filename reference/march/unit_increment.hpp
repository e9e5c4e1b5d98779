#pragma once

#include "problem/problem.hpp"

namespace fde {

// What f_i = 1 adds to y_i over a step: int_0^length (length - s)^(order-1) / Gamma(order) ds.
Vec unit_increment(const Problem& problem, double length);

}  // namespace fde
