#pragma once

#include <vector>

#include "reference.hpp"

namespace fde {

// One term coefficient * t^(power + multiple * order), the exponent put together at the precision asked for.
struct Power {
  double coefficient, power, multiple = 0.0;
};

// Their sum, with its digits: for problems made from a known solution.
Reference power_sum(const std::vector<Power>& terms, double order = 0.0);

}  // namespace fde
