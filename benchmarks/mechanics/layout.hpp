// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace fde::bench::mechanics {

// A block of `size` consecutive rows of a state, starting at row `first`.
struct RowBlock {
  int first = 0, size = 0;

  [[nodiscard]] constexpr bool contains(int row) const { return first <= row && row < first + size; }
  // The index of its i-th row.
  [[nodiscard]] constexpr std::size_t operator[](int i) const {
    return static_cast<std::size_t>(first) + static_cast<std::size_t>(i);
  }
};

// The blocks of rows of a formulation's state; absent blocks are empty.
struct Layout {
  RowBlock q{};       // coordinates
  RowBlock v{};       // velocities
  RowBlock z{};       // P v, the part of v not determined by the constraints
  RowBlock chi{};     // b.v, the part that they determine for order > 1
  RowBlock s{};       // D^order v
  RowBlock w{};       // D^order q; for order > 1 in the integrated formulation, P D^order q
  RowBlock p{};       // momenta
  RowBlock lambda{};  // multipliers

  [[nodiscard]] constexpr int size() const {
    int sum = 0;
    for (const RowBlock& group : groups()) sum += group.size;
    return sum;
  }
  // Whether every row is in exactly one block.
  [[nodiscard]] constexpr bool is_partition() const {
    for (int row = 0; row < size(); ++row) {
      int found = 0;
      for (const RowBlock& group : groups()) found += group.contains(row) ? 1 : 0;
      if (found != 1) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] constexpr std::array<RowBlock, 8> groups() const { return {q, v, z, chi, s, w, p, lambda}; }
};

// The rows of a block.
template <RowBlock group, class Unknowns>
auto part(const Unknowns& y) {
  return y.template segment<group.size>(group.first);
}
template <RowBlock group, class Unknowns>
auto part(Unknowns& y) {
  return y.template segment<group.size>(group.first);
}

}  // namespace fde::bench::mechanics
