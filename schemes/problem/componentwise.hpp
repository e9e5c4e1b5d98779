// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Calls body(i) for each component i without vector instructions. The right-hand side, the memory sums and
// the result of a step are written one double at a time. A vector load that spans several such stores cannot
// be forwarded from the store buffer and stalls until they are retired; with few components the stall costs
// more than the arithmetic.
template <typename Body>
inline void for_each_component(Eigen::Index size, Body body) {
#if defined(__clang__)
#pragma clang loop unroll_count(4)
#else
#pragma GCC unroll 4
#endif
  for (Eigen::Index i = 0; i < size; ++i) {
    body(i);
    asm volatile("");  // NOLINT(hicpp-no-assembler): compilers do not vectorise a loop with it
  }
}

}  // namespace fde
