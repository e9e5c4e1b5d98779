#pragma once

#include "transfer_functions/characteristic_function.hpp"

namespace fde {

// All zeros of the characteristic function of a linear problem inside the strip |Im w| < pi, counted by the
// argument principle; std::runtime_error where search and count do not agree.
std::vector<Zero<long double>> find_zeros(const LinearTransform& transform);

}  // namespace fde
