// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/programs/google/bare_loop.hpp"

#include <array>

namespace fde::bench {

#if defined(__x86_64__) && defined(__clang__)
__attribute__((target_clones("avx512f", "avx2", "default")))
#elif defined(__x86_64__)
__attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif
void bare_multiply_add(Eigen::Index inner, Eigen::Index columns, const double* a, const double* b, double* c) {
  constexpr Eigen::Index rows = 32;
  for (Eigen::Index j = 0; j < columns; ++j) {
    std::array<double, rows> sum;
    for (Eigen::Index i = 0; i < rows; ++i) sum[i] = c[i + rows * j];
    for (Eigen::Index k = 0; k < inner; ++k) {
      for (Eigen::Index i = 0; i < rows; ++i) sum[i] += a[i + rows * k] * b[k + inner * j];
    }
    for (Eigen::Index i = 0; i < rows; ++i) c[i + rows * j] = sum[i];
  }
}

}  // namespace fde::bench
