// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/linear/transfer_functions/characteristic_function.hpp"
#include "fdebench/reference/reference.hpp"

namespace fde::reference {

// All zeros of the characteristic function of a linear problem inside the strip |Im w| < pi, counted by the
// argument principle. Throws std::runtime_error where the search finds fewer than the count, or where a
// solution overflows at once.
std::vector<Zero<long double>> find_zeros(const LinearTransform& transform);

// The same as values of s, by decreasing real part, with those on the negative axis, and s = 0 where P(0) =
// 0.
std::vector<CharacteristicZero> characteristic_zeros(const LinearTransform& transform);

}  // namespace fde::reference
