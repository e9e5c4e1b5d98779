// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/zero_matrix.hpp"

#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/problem/large_pages.hpp"

namespace fde {

void make_zero(Matrix& matrix, Eigen::Index rows, Eigen::Index columns) {
  allocate(matrix, rows, columns);
  for_each_row(matrix.size(), [to = matrix.data()](Eigen::Index i) { to[i] = 0.0; });
}

}  // namespace fde
