// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/large_pages.hpp"

#include <sys/mman.h>

#include <memory>

namespace fde {

void allocate(Matrix& matrix, Eigen::Index rows, Eigen::Index columns) {
  matrix.resize(rows, columns);
#ifdef MADV_HUGEPAGE
  constexpr std::size_t page = 0x1000, large = 0x800000;
  std::size_t bytes = sizeof(double) * static_cast<std::size_t>(matrix.size());
  void* data = matrix.data();
  if (bytes < large || std::align(page, page, data, bytes) == nullptr) return;
  madvise(data, bytes / page * page, MADV_HUGEPAGE);  // only advice: there need be no large pages
#endif
}

}  // namespace fde
