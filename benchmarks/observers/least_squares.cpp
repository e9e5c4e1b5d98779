// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/least_squares.hpp"

#include <Eigen/QR>

namespace fde::bench {

reference::LongMatrix least_squares(const reference::LongMatrix& a, const reference::LongMatrix& b) {
  const Eigen::ColPivHouseholderQR<reference::LongMatrix> orthogonal(a);
  reference::LongMatrix x(a.cols(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j) x.col(j) = orthogonal.solve(reference::LongVec(b.col(j)));
  return x;
}

}  // namespace fde::bench
