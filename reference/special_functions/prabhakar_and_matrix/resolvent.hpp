// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// A square matrix of multiprecision numbers, row by row.
struct BigMatrix {
  int size = 0;
  std::vector<BigComplex> entries{};

  [[nodiscard]] BigComplex& operator()(int i, int j) { return entries[index(i, j)]; }
  [[nodiscard]] const BigComplex& operator()(int i, int j) const { return entries[index(i, j)]; }
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(size) + static_cast<std::size_t>(j);
  }
};

// An approximate inverse X of M, its row norm (maximum row sum), and a bound of the row norm of its error,
// |X| |R| / (1 - |R|) with R = I - M X; infinite unless |R| < 1.
struct BoundedInverse {
  BigMatrix value;
  BigReal norm, bound;
};
BoundedInverse bounded_inverse(const BigMatrix& matrix);

}  // namespace fde::reference
