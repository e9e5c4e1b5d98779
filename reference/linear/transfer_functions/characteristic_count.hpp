// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/reference/linear/transfer_functions/characteristic_function.hpp"

namespace fde::reference {

// |Im w| <= height, left <= Re w <= right.
struct Rectangle {
  using Point = Complex<long double>;
  long double left, right, height;

  [[nodiscard]] bool contains(const Point& w) const {
    return w.real() >= left && w.real() <= right && std::abs(w.imag()) <= height;
  }
};

// Number of zeros inside, by the argument principle; nullopt where a zero is too close to the sides.
std::optional<int> count_zeros(const CharacteristicFunction& function, const Rectangle& box);

}  // namespace fde::reference
