// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <algorithm>
#include <functional>
#include <vector>

namespace fde {

// Vectors and matrices of doubles, and parameter types of functions: In is read; Out and OutMatrix are
// written and already have their size.
using Vec = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using ComplexMatrix = Eigen::MatrixXcd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using In = const Eigen::Ref<const Vec>&;
using Out = Eigen::Ref<Vec>;
using OutMatrix = Eigen::Ref<Matrix>;

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

// The values in increasing order, each once: of values that are the same the first remains.
template <class Value, class Same = std::equal_to<>>
std::vector<Value> increasing(std::vector<Value> values, const Same& same = {}) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  return values;
}

}  // namespace fde
