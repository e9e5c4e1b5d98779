#pragma once

#include "problem/vectors.hpp"

namespace fde {

// Calls body(i) for each component i, one component at a time: no vector instructions. A right-hand side, the
// sums of the past and the result of a step are written one double at a time, and a vector read from several
// such writes waits until all of them have left the processor's queue: in a step of few components that is
// longer than the arithmetic.
template <typename Body>
inline void for_each_component(Eigen::Index size, Body body) {
  for (Eigen::Index i = 0; i < size; ++i) {
    body(i);
    asm volatile("");  // NOLINT(hicpp-no-assembler): compilers do not vectorise a loop with it
  }
}

}  // namespace fde
