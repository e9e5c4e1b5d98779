// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/linear/transfer_functions/characteristic_function.hpp"

namespace fde::reference {

// All zeros of the characteristic function of a linear problem inside the strip |Im w| < pi, counted by the
// argument principle. Throws std::runtime_error where the search finds fewer than the count, or where a
// solution overflows at once.
std::vector<Zero<long double>> find_zeros(const LinearTransform& transform);

}  // namespace fde::reference
