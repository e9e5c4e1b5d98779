// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// A square matrix of multiprecision numbers, row by row.
struct BigMatrix {
  int size = 0;
  std::vector<BigComplex> entries{};

  [[nodiscard]] const BigComplex& operator()(int i, int j) const { return entries[index(i, j)]; }
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(size) + static_cast<std::size_t>(j);
  }
  [[nodiscard]] bool real() const {
    return std::ranges::all_of(entries, [](const BigComplex& x) { return imag_part<BigReal>(x) == 0; });
  }
};

}  // namespace fde::reference
