// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "fdebench/benchmarks/scenes/parameters.hpp"

namespace fde::bench {

// The initial values of a component from its parameters, given by name: y(0), and y'(0) if its order is above
// 1. Throws std::invalid_argument naming the slope if the order is at most 1 and the slope is not 0.
std::vector<double> initial_values(const Parameters& p, std::string_view order, std::string_view value,
                                   std::string_view slope);

}  // namespace fde::bench
