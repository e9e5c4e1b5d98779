#pragma once

#include <string_view>
#include <vector>

#include "scenes/parameters.hpp"

namespace fde {

// The initial values of a component, by the names of its parameters: y(0), and y'(0) where its order is above
// 1. Throws std::invalid_argument naming the slope where the order is not and the slope is not 0.
std::vector<double> initial_values(const Parameters& p, std::string_view order, std::string_view value,
                                   std::string_view slope);

}  // namespace fde
